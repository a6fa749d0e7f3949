"""Where the records come from, and what must be said about that."""

from collections import Counter


def commit_of(record):
    program = record.get("manifest", {}).get("program", {})
    commit = program.get("commit", "unknown")
    return commit[:10] + ("+changes" if program.get("dirty") else "")


def host_of(record):
    host = record.get("volatile", {}).get("host", {})
    if not host:
        return "unknown"
    return f"{host['cpu_model']}, {host['cores']} threads, {host['os']}"


def join(words):
    return "; ".join(sorted(words)) or "none"


def commits(records):
    return sorted({commit_of(r) for r in records if "manifest" in r})


def hosts(records):
    return sorted({host_of(r) for r in records if "volatile" in r})


def origin(records):
    """`machine ...; commit ...`, for captions."""
    return (f"machine: {join(hosts(records))}; "
            f"commit: {join(commits(records))}")


def references(runs):
    """`povray 9, self 7 scenes`."""
    kinds = {run.scene: run.settings["reference"] for run in runs}
    counts = Counter(kinds.values())
    return ", ".join(f"{name} ({count} scene{'' if count == 1 else 's'})"
                     for name, count in sorted(counts.items()))


def warnings(results):
    """What a reader must know before trusting the figures."""
    found = []
    several = commits(results.records)
    if len(several) > 1:
        found.append(f"the records come from {len(several)} commits: "
                     + join(several))
    if any(commit.endswith("+changes") for commit in several):
        found.append("some records come from a program with uncommitted "
                     "changes")
    timed = [run.record for run in results.timed()]
    machines = hosts(timed)
    if len(machines) > 1:
        found.append(f"times come from {len(machines)} machines: "
                     + join(machines))
    elif len(hosts(results.records)) > 1:
        found.append("the records come from several machines: "
                     + join(hosts(results.records)))
    restless = restless_stages(results)
    if restless:
        found.append(f"{len(restless)} of the timed stages vary by more than "
                     f"{100 * MOST_CV:.0f} % (coefficient of variation): the "
                     "machine was busy, or the stage is very short")
    return found


MOST_CV = 0.10


def restless_stages(results):
    """(run, stage) of the stages whose times are too unsteady to compare."""
    return [(run, stage) for run in results.timed()
            for stage, times in run.data["ms"].items()
            if isinstance(times, dict) and (times.get("cv") or 0) > MOST_CV]
