#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""Programs of a release are hardened. Run by ctest: test_hardening.py <program> ..."""
import re
import subprocess
import sys

faults = []
for program in sys.argv[1:]:
    shown = subprocess.run(["readelf", "--file-header", "--program-headers", "--dynamic", "--dyn-syms", "--wide", program],
                           capture_output=True, text=True, check=True).stdout
    wanted = {
        "lies at random addresses (PIE)": r"Type:\s+DYN",
        "has read-only relocations (relro)": r"GNU_RELRO",
        "binds everything at the start (now)": r"\(FLAGS(_1)?\).*\bNOW\b",
        "has a stack that holds no code": r"GNU_STACK\s.*\sRW\s",
        "checks its stack (stack protector)": r" UND __stack_chk_fail",
        "checks its buffers (_FORTIFY_SOURCE)": r" UND __\w+_chk(@|\s)",
        "checks its indices (_GLIBCXX_ASSERTIONS)": r" UND \w*__glibcxx_assert_fail",
    }
    faults += [f"{program}: not found that it {what}" for what, pattern in wanted.items() if not re.search(pattern, shown)]
if faults:
    sys.exit("\n".join(faults))
print(f"{len(sys.argv) - 1} programs are hardened.")
