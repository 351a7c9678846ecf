# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""What the tests of the package share: a small drop that runs in a moment, its recording, and the command line."""
import json
import os
import pathlib
import subprocess

import pytest

import hygroloom

SOURCE = pathlib.Path(os.environ.get("HYGROLOOM_SOURCE", pathlib.Path(__file__).resolve().parents[2]))
EXAMPLES = SOURCE / "resources/examples"
PROGRAM = os.environ.get("HYGROLOOM_CLI") or SOURCE / "build/release/bin/hygroloom-cli"


def pytest_configure(config):
    config.addinivalue_line("markers", "slow: runs of several seconds")


@pytest.fixture(scope="session")
def examples():
    return EXAMPLES


@pytest.fixture
def small():
    """A drop of 2 ul on 8 x 8 mm for half a second."""
    project = hygroloom.Project.open(EXAMPLES / "one-drop-on-cotton.hygro")
    name = project.experiments[0]
    project.set(f"experiments.{name}.sample_mm", [8, 8]).set(f"experiments.{name}.duration_s", 0.5)
    return project.set(f"experiments.{name}.droplets[0].volume_ul", 2)


@pytest.fixture(scope="session")
def cli():
    """Runs hygroloom-cli and gives its JSON."""

    def run(*arguments):
        ended = subprocess.run([PROGRAM, *map(str, arguments), "--json", "--quiet"], capture_output=True, text=True, timeout=120)
        assert ended.returncode == 0, ended.stderr
        return json.loads(ended.stdout)

    return run
