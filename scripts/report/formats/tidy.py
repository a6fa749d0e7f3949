"""CSV: runs.csv with one row a run and every field, and each table."""

import csv

import report.provenance as provenance


def flatten(value, name=""):
    """(dotted name, text) of every leaf; lists are joined by spaces."""
    if isinstance(value, dict):
        for key, inner in value.items():
            yield from flatten(inner, f"{name}.{key}" if name else key)
    elif isinstance(value, list):
        yield name, " ".join(map(str, value))
    elif isinstance(value, bool):
        yield name, "true" if value else "false"
    else:
        yield name, "" if value is None else value


def fields(run):
    """Everything known of a run."""
    row = {"kind": run.kind, "file": run.file}
    row.update(flatten(run.data))
    manifest = run.record["manifest"]
    row.update(flatten(manifest["settings"], "settings"))
    row.update(flatten(manifest["program"], "program"))
    for given in manifest.get("inputs", []):
        key = f"inputs.{given['role']}"
        text = f"{given['name']} {given['sha256']}"
        row[key] = f"{row[key]}; {text}" if key in row else text
    row.update(flatten(run.record.get("volatile", {}), "volatile"))
    unit = run.record.get("unit", {})
    row.update(flatten({k: unit[k] for k in ("suite", "hash") if k in unit},
                       "unit"))
    return row


def write_rows(file, rows):
    """Rows (dicts) under the union of their keys, in order of appearance."""
    names = list(dict.fromkeys(name for row in rows for name in row))
    with file.open("w", encoding="utf-8", newline="") as stream:
        writer = csv.DictWriter(stream, names, restval="",
                                lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    return file


def failure_rows(results):
    rows = []
    for record in results.failures:
        row = dict(flatten(record["failure"]))
        row.update(flatten(record.get("unit", {}), "unit"))
        row["commit"] = provenance.commit_of(record)
        rows.append(row)
    return rows


def write_table(file, table):
    with file.open("w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow([column.heading for column in table.columns]
                        + list(table.stated))
        for row in table.rows:
            writer.writerow([cell.value() for cell in row]
                            + list(table.stated.values()))
    return file


def write(folder, results, tables):
    """Returns the files written."""
    files = [write_rows(folder / "runs.csv",
                        [fields(run) for run in results.runs])]
    if results.failures:
        files.append(write_rows(folder / "failures.csv",
                                failure_rows(results)))
    (folder / "tables").mkdir(exist_ok=True)
    files += [write_table(folder / "tables" / f"{table.name}.csv", table)
              for table in tables]
    return files
