#!/usr/bin/python3
"""Tells Snakemake how a job of Slurm's fares.

    status.py JOB

Prints `running`, `success` or `failed`. Asks the controller, so that no
accounting database is needed; it forgets a job a few minutes after its end
(MinJobAge), and a job that it does not know counts as failed: it is submitted
again, and the sweep goes on where it stood.
"""

import re
import subprocess
import sys

SUCCESS = {"COMPLETED"}
FAILED = {"BOOT_FAIL", "CANCELLED", "DEADLINE", "FAILED", "NODE_FAIL",
          "OUT_OF_MEMORY", "PREEMPTED", "REVOKED", "TIMEOUT"}


def state(text):
    """The state in what `scontrol show job` prints; None without one."""
    match = re.search(r"\bJobState=(\w+)", text)
    return match.group(1) if match else None


def verdict(text):
    found = state(text)
    if found in SUCCESS:
        return "success"
    return "failed" if found is None or found in FAILED else "running"


def main():
    if len(sys.argv) != 2:
        print(__doc__.split("\n\n")[1].strip(), file=sys.stderr)
        return 2
    asked = subprocess.run(["scontrol", "-o", "show", "job", sys.argv[1]],
                           stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                           check=False)
    error = asked.stderr.decode()
    if asked.returncode != 0 and "Invalid job id" not in error:
        print("running")  # The controller is busy; the next answer counts.
    else:
        print(verdict(asked.stdout.decode()))
    return 0


if __name__ == "__main__":
    sys.exit(main())
