"""A machine that is not there: the scripts in a tree of their own, with fake
package tools, compilers and programs that write down how they were called."""

import shutil

from script_case import ROOT, ScriptTest

# The real programs that the scripts may use besides bash.
TOOLS = ["bash", "env", "cat", "mktemp", "rm", "mkdir", "flock", "grep",
         "touch", "nproc", "cp", "chmod"]

# Says which of the asked packages stand in $INSTALLED, as dpkg-query does.
DPKG_QUERY = '''#!/bin/bash
for package in "$@"; do
  if grep -qx "$package" "$STATE/installed"; then echo "$package installed"
  elif [[ $package == half-removed ]]; then echo "$package config-files"
  fi
done
'''

# Installs by writing names down; without package lists it finds nothing.
APT_GET = '''#!/bin/bash
echo "apt-get $*" >>"$STATE/calls"
echo "frontend $DEBIAN_FRONTEND" >>"$STATE/calls"
case " $* " in
  *" update "*) [[ -e $STATE/offline ]] && exit 100; touch "$STATE/lists" ;;
  *" install "*)
    if [[ ! -e $STATE/lists ]]; then echo "E: Unable to locate"; exit 100; fi
    for word in "$@"; do echo "$word"; done >>"$STATE/installed" ;;
esac
echo "noise of apt"
'''

CMAKE = '''#!/bin/bash
echo "cmake $*" >>"$STATE/calls"
echo "noise of cmake"
if [[ -e $STATE/cmake-fails ]]; then echo "no such library"; exit 1; fi
mkdir -p "build/${2}"
touch "build/${2}/build.ninja"
'''

NINJA = '''#!/bin/bash
echo "ninja $*" >>"$STATE/calls"
echo "[1/2] Building CXX object a.o"
if [[ -e $STATE/ninja-fails ]]; then echo "a.cc:1: error: bad"; exit 1; fi
echo "[2/2] Linking CXX executable rtbench"
cp "$STATE/program" "$2/rtbench"
'''

PROGRAM = '''#!/bin/bash
echo "program in $PWD with:" "$@"
'''

CTEST = '''#!/bin/bash
echo "ctest $*" >>"$STATE/calls"
echo "100% tests passed"
'''


class FakeMachineTest(ScriptTest):
    """A test case on a fresh machine: nothing installed, the user is root."""

    def setUp(self):
        super().setUp()
        shutil.copytree(ROOT / "scripts", self.tree / "repo/scripts")
        self.write("state/installed")
        self.write("state/calls")
        self.write("state/lists")
        self.write("state/program", PROGRAM, executable=True)
        (self.tree / "bin").mkdir()
        for tool in TOOLS:
            (self.tree / "bin" / tool).symlink_to(shutil.which(tool))
        self.fake("dpkg-query", DPKG_QUERY)
        self.fake("apt-get", APT_GET)
        self.fake("cmake", CMAKE)
        self.fake("ninja", NINJA)
        self.fake("ctest", CTEST)
        self.become(0)

    def fake(self, name, text):
        self.write(f"bin/{name}", text, executable=True)

    def become(self, user):
        self.fake("id", f"#!/bin/bash\necho {user}\n")

    def packages(self, *sections):
        """The packages of the list's sections, read without the script."""
        text = (ROOT / "scripts/packages.txt").read_text()
        found, section = [], None
        for line in text.split("\n"):
            word = line.split("#")[0].strip()
            if word.startswith("["):
                section = word.strip("[]")
            elif word and section in sections:
                found.append(word)
        return found

    def install(self, packages):
        self.write("state/installed", "".join(p + "\n" for p in packages))

    def script(self, name, *arguments, **environment):
        """Runs a script with nothing but the fakes on PATH."""
        return self.run_command(
            self.tree / "repo/scripts" / name, *arguments,
            PATH=str(self.tree / "bin"), STATE=str(self.tree / "state"),
            RTB_PRESET=None, RTB_JOBS=None, RTB_SKIP_SETUP=None,
            **environment)

    def calls(self):
        """How the fakes were called so far."""
        return (self.tree / "state/calls").read_text().splitlines()
