"""Slurm on this machine alone, for a test: munge, slurmctld and slurmd on the
loopback device, with configuration, keys and ports of their own in a folder
that goes with them."""

import getpass
import os
import secrets
import shutil
import socket
import subprocess
import time
from pathlib import Path

PROGRAMS = ["munged", "slurmctld", "slurmd", "sbatch", "squeue", "scontrol"]
PATH = os.environ.get("PATH", "") + ":/usr/sbin:/sbin"

CONFIGURATION = """\
ClusterName=loopback
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller}
SlurmdPort={daemon}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CredType=cred/munge
MpiDefault=none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=sched_interval=1,batch_sched_delay=0
ReturnToService=2
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
NodeName={host} NodeAddr=127.0.0.1 CPUs={cores} State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP \
OverSubscribe=NO
"""


class SlurmMissing(Exception):
    """Why Slurm cannot be had here."""


def missing_program():
    """The name of a program that is not installed, or None."""
    return next((name for name in PROGRAMS
                 if shutil.which(name, path=PATH) is None), None)


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class LocalSlurm:
    """The daemons. `environment` is what Slurm's commands need."""

    def __init__(self, folder):
        self.folder = Path(folder)
        self.daemons = []
        self.environment = dict(os.environ, PATH=PATH,
                                SLURM_CONF=str(self.folder / "slurm.conf"))
        try:
            self._start()
        except Exception:
            self.stop()
            raise

    def _start(self):
        absent = missing_program()
        if absent:
            raise SlurmMissing(f"{absent} is not installed (slurm-wlm, munge)")
        host = socket.gethostname().split(".")[0]
        for part in ["state", "spool"]:
            (self.folder / part).mkdir()
        key = self.folder / "munge.key"
        key.touch(mode=0o600)
        key.write_bytes(secrets.token_bytes(128))
        (self.folder / "slurm.conf").write_text(CONFIGURATION.format(
            host=host, folder=self.folder, user=getpass.getuser(),
            controller=free_port(), daemon=free_port(), cores=os.cpu_count()))
        self._run("munged", "--foreground", "--force", f"--key-file={key}",
                  *(f"--{name}-file={self.folder}/munge.{name}"
                    for name in ["log", "pid", "seed"]),
                  f"--socket={self.folder}/munge.socket")
        self._wait_for("munge", lambda: (self.folder / "munge.socket").exists())
        self._run("slurmctld", "-D")
        self._run("slurmd", "-D", "-N", host)
        self._wait_for("the node", lambda: "idle" in self.command(
            "sinfo", "-h", "-o", "%T"))

    def _run(self, *command):
        with (self.folder / f"{command[0]}.out").open("wb") as log:
            self.daemons.append(subprocess.Popen(
                command, env=self.environment, stdout=log, stderr=log,
                stdin=subprocess.DEVNULL))

    def _wait_for(self, what, there, seconds=60):
        end = time.monotonic() + seconds
        while not there():
            ended = [d.args[0] for d in self.daemons if d.poll() is not None]
            if ended or time.monotonic() > end:
                logs = "".join(
                    path.read_text(errors="replace")[-600:] for pattern in
                    ["*.out", "*.log"] for path in self.folder.glob(pattern))
                raise SlurmMissing(f"{what} does not come up here: {logs}")
            time.sleep(0.1)

    def command(self, *command):
        """What a command of Slurm's prints; empty where it fails."""
        return subprocess.run(command, env=self.environment, timeout=60,
                              check=False, stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL).stdout.decode()

    def stop(self):
        for daemon in reversed(self.daemons):
            daemon.terminate()
        for daemon in reversed(self.daemons):
            try:
                daemon.wait(20)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()
        self.daemons = []
