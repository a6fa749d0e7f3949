#!/usr/bin/python3
"""A sweep in slices through Snakemake and Slurm is the sweep of one machine.

What is not installed, or may not be started here, is skipped by name.
"""

import getpass
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

from local_slurm import LocalSlurm, SlurmMissing
from program import ROOT
from sweeps import SweepTest, contents

CLUSTER = ROOT / "scripts" / "cluster"


class ClusterTest(SweepTest):
    """What the tests share."""

    def check_whole(self, folder):
        """The folder holds what a local sweep leaves, times aside."""
        self.sweep("local")
        local = contents(self.folder / "local")
        found = contents(self.folder / folder)
        self.assertEqual(sorted(found), sorted(local))
        self.assertEqual(found, local)

    def run_cluster(self, *command, environment=None, seconds=240):
        """A command's standard output; it must succeed."""
        process = subprocess.run(
            [*map(str, command)], cwd=self.folder, timeout=seconds, check=False,
            env=dict(environment or self.environment(),
                     RTBENCH_CACHE=str(self.folder / "cache")), stdout=subprocess.PIPE,
            stderr=subprocess.PIPE)
        logs = [path.read_text() for path in self.folder.rglob("rtbench-*.log")]
        self.assertEqual(process.returncode, 0,
                         process.stderr.decode() + "\n".join(logs))
        return process.stdout.decode()

    def snakemake(self, *options, **more):
        if shutil.which("snakemake") is None:
            self.skipTest("snakemake is not installed")
        # Its notes on what it has seen go below the home folder.
        environment = dict(more.pop("environment", self.environment()),
                           HOME=str(self.folder))
        self.run_cluster(
            "snakemake", "-s", CLUSTER / "Snakefile", *options, "--config",
            f"suite={self.suite}", "out=sliced", "shards=2",
            f"rtbench={self.program}", environment=environment, **more)


class SnakemakeTest(ClusterTest):

    def test_this_machine(self):
        self.snakemake("--cores=2")
        self.check_whole("sliced")
        # Everything is done: a second run starts nothing.
        before = (self.folder / "sliced" / "units").stat().st_mtime_ns
        self.snakemake("--cores=2")
        after = (self.folder / "sliced" / "units").stat().st_mtime_ns
        self.assertEqual(before, after)


class SlurmTest(ClusterTest):
    """With Slurm's daemons on the loopback device."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        folder = tempfile.mkdtemp(prefix="rtbench_slurm_")
        cls.addClassCleanup(shutil.rmtree, folder)
        try:
            cls.slurm = LocalSlurm(folder)
        except SlurmMissing as missing:
            print(f"skipped: {missing}", file=sys.stderr)
            raise unittest.SkipTest(str(missing)) from missing
        cls.addClassCleanup(cls.slurm.stop)

    def wait_for_jobs(self, seconds=240):
        end = time.monotonic() + seconds
        while self.slurm.command("squeue", "-h", "-u", getpass.getuser()):
            self.assertLess(time.monotonic(), end, "the jobs do not end")
            time.sleep(0.3)

    def test_job_array(self):
        environment = dict(self.slurm.environment, RTBENCH=str(self.program))
        for kinds in ["quality,temporal", "timing,live"]:
            self.run_cluster("sbatch", "--array=0-1",
                             CLUSTER / "sweep.sbatch", self.suite, "sliced",
                             f"--kinds={kinds}", environment=environment)
            self.wait_for_jobs()
        logs = "".join(path.read_text()
                       for path in sorted(self.folder.glob("rtbench-*.log")))
        self.assertEqual(logs.count("units done"), 4, logs)
        self.check_whole("sliced")

    def test_snakemake_through_slurm(self):
        self.snakemake("--profile", CLUSTER / "slurm", "--latency-wait=20",
                       "--max-status-checks-per-second=5", "--jobs=2",
                       environment=self.slurm.environment)
        logs = list((self.folder / "sliced.slices").glob("*.log"))
        self.assertEqual(len(logs), 4)  # 2 slices of quality, 2 of timing
        self.check_whole("sliced")


class StatusTest(unittest.TestCase):
    """scripts/cluster/slurm/status.py reads what scontrol prints."""

    def test_verdicts(self):
        sys.path.insert(0, str(CLUSTER / "slurm"))
        self.addCleanup(sys.path.remove, str(CLUSTER / "slurm"))
        import status  # pylint: disable=import-outside-toplevel
        for state, verdict in [("COMPLETED", "success"), ("FAILED", "failed"),
                               ("CANCELLED", "failed"), ("RUNNING", "running"),
                               ("PENDING", "running"), ("TIMEOUT", "failed"),
                               ("COMPLETING", "running")]:
            text = f"JobId=7 JobName=x JobState={state} Reason=None"
            self.assertEqual(status.verdict(text), verdict)
        self.assertEqual(status.verdict(""), "failed")


if __name__ == "__main__":
    unittest.main()
