# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""A run that needs more memory than is free is refused before it begins."""
import subprocess
import sys
import textwrap

SCRIPT = """
    import resource, sys, hygroloom
    project = hygroloom.Project.open(sys.argv[1]).set("experiments[0].sample_mm", [400, 400])
    taken = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
    resource.setrlimit(resource.RLIMIT_AS, (taken + 300_000_000, resource.RLIM_INFINITY))
    begun = []
    def stop(share, words):
        begun.append(share)
        raise KeyError("begun")
    for force in (False, True):
        try:
            hygroloom.simulate(project, fidelity="live", recording=False, force=force, progress=stop)
        except hygroloom.Error as error:
            print(error)
        except (KeyError, MemoryError):
            print("begun")
"""


def test_both_numbers_are_told_and_force_begins(small, tmp_path):
    project = small.save(tmp_path / "small.hygro")
    done = subprocess.run([sys.executable, "-c", textwrap.dedent(SCRIPT), project], capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    refused, forced = done.stdout.splitlines()
    assert refused.startswith("This run takes about ") and " MB are free " in refused
    assert refused.endswith("Take a smaller sample or a lower fidelity, or begin all the same with force=True.")
    assert forced == "begun"
