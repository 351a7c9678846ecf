#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""The programs use no network and write only what was named. What is compiled here calls no function of sockets; every verb works in a namespace without
network in which all but one folder is read-only, and leaves there only the files that were named; the window keeps to its XDG folders.
Run by ctest: check_seclusion.py [--linked-only] <root of the source> <hygroloom-cli> [<hygroloom>]; --linked-only looks at what is linked and called,
and runs nothing."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77
STUDY = """{"format": "hygroloom-study", "version": 1, "fabrics": ["Cotton plain"], "experiments": ["one drop"], "fidelity": "live",
  "factors": [{"path": "fabrics[0].contact_angle_deg", "values": [30, 50]}], "design": {"type": "grid"}}"""
STRIP = "time_s,wick_height_mm,spread\n0.5,7.8,0.1\n1,11,0.1\n1.5,13.5,0.1\n"
YARNS = "name,material,count\nfine,cotton 60 + polyester 40,Ne 40\n"
MESH = "tests/data/garments/sheet.dae"
PANEL = "v 0 0 0\nv 0.1 0 0\nv 0.1 0.2 0\nv 0 0.2 0\nvt 0 0\nvt 0.5 0\nvt 0.5 1\nvt 0 1\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n"
NETWORK_LIBRARY = re.compile(r"curl|ssl|crypto|Qt\d?(Network|WebSockets|WebEngine|HttpServer)|nghttp|ldap|libssh|resolv|libzmq|libuv|gnutls")
NETWORK_FUNCTION = re.compile(
    r"^(socket|socketpair|connect|bind|listen|accept4?|send(to|msg|mmsg)?|recv(from|msg|mmsg)?|getaddrinfo|gethostby\w+|res_\w+|curl_\w+|SSL_\w+)$")


def linked_faults(program):
    shown = subprocess.run(["readelf", "--dynamic", "--wide", program], capture_output=True, text=True, check=True).stdout
    libraries = re.findall(r"NEEDED\).*\[(.*)\]", shown)
    if not libraries:
        return [f"{program}: readelf shows nothing"]
    return [f"{program} links {name}" for name in libraries if NETWORK_LIBRARY.search(name)]


def called_faults(program):
    """Of what is compiled here: the CUDA runtime, which may be linked in, has functions of sockets of its own."""
    build = pathlib.Path(program).resolve().parents[1]
    objects = [*build.glob("*/libhygroloom_*.a"), *build.glob("app/CMakeFiles/hygroloom*.dir/**/*.o")]
    shown = subprocess.run(["nm", "--undefined-only", "--format=posix", *objects], capture_output=True, text=True, check=True).stdout
    functions = sorted({line.split()[0] for line in shown.splitlines() if line.endswith(" U") or " U " in line})
    if len(functions) < 1000:
        return [f"nm shows {len(functions)} functions that {program} calls"]
    return [f"the program calls {name}" for name in functions if NETWORK_FUNCTION.match(name)]


def verbs(root):
    """Arguments of a call of each verb, and what it may write into the folder it is called in."""
    project = root / "resources/examples/three-candidates.hygro"
    drop = ["--experiment", "one drop"]
    short = ["--fidelity", "draft", "--set", "experiments[0].duration_s=0.05", "--quiet"]
    one = [project, "--fabric", "Cotton plain"]
    strip = [root / "resources/examples/laboratory.hygro", "--fabric", "Textile F", "--experiment", "vertical wicking", "--fidelity", "live",
             "--set", "experiments[vertical wicking].duration_s=1.5", "--set", "experiments[vertical wicking].strip_mm=[3,30]"]
    return [
        (["check", project], []),
        (["card", *one, "-o", "card.html", "--quiet"], ["card.html"]),
        (["plan", *one, *drop, "--fidelity", "draft"], []),
        (["simulate", *one, *drop, *short, "-o", "run.hygrorec"], ["run.hygrorec"]),
        (["measure", "run.hygrorec", "--map", "top", "-o", "map.png", "--report", "report.html", "--quiet"], ["map.png", "report.html"]),
        (["measure", "run.hygrorec", "--vtk", "frames", "--quiet"], ["frames"]),
        (["measure", "run.hygrorec", "--netcdf", "run.nc", "--quiet"], ["run.nc"]),
        (["export", *one, "-o", "cloth.glb", "--size-mm", "2x2", "--quiet"], ["cloth.glb"]),
        (["export", *one, "-o", "cloth.wif", "--quiet"], ["cloth.wif"]),
        (["import", "cloth.wif", "-o", "imported.hygro"], ["imported.hygro"]),
        (["presets", "Denim", "-o", "imported.hygro"], ["imported.hygro~"]),  # the version before
        (["yarns", "own.hygrolib", "--read", "../yarns.csv", "--write", "again.csv", "--quiet"], ["own.hygrolib", "again.csv"]),
        (["devices"], []),
        (["help", "simulate"], []),
        (["compare", project, "--fabrics", "Cotton plain,Cotton twill", *drop, *short, "-o", "compared"], ["compared"]),
        (["tradeoff", *one, *drop, *short[2:], "--fidelities", "draft", "--repeats", "1", "-o", "tradeoff.json"], ["tradeoff.json"]),
        (["sweep", project, "--study", "../study.json", "-o", "swept", "--set", "experiments[0].duration_s=0.05", "--quiet"], ["swept"]),
        (["calibrate", *strip, "--measured", "../strip.csv", "--free", "contact_angle_deg", "--quiet", "-o", "fitted.hygro"], ["fitted.hygro"]),
        (["garment", "import", "built-in:tee", "--fabric", "Poplin shirting", "-o", "tee.hygro"], ["tee.hygro"]),
        (["garment", "import", "../panel.obj", "--fabric", "Poplin shirting", "-o", "panel.hygro"], ["panel.hygro"]),
        (["garment", "import", root / MESH, "--fabric", "Poplin shirting", "-o", "sheet.hygro"], ["sheet.hygro"]),
        (["check", "sheet.hygro"], []),
        (["garment", "plan", "tee.hygro", "--fidelity", "live"], []),
        (["simulate", "tee.hygro", "--fidelity", "live", "--set", "experiments[0].duration_s=5", "--quiet", "-o", "worn.hygrorec"], ["worn.hygrorec"]),
        (["garment", "map", "worn.hygrorec", "-o", "maps", "--report", "worn.html", "--quiet"], ["maps", "worn.html"]),
        (["verify", "washburn"], []),
        (["reference"], []),
    ]


def surroundings(home):
    folders = {"HOME": "", "XDG_CONFIG_HOME": "config", "XDG_DATA_HOME": "data", "XDG_CACHE_HOME": "cache", "XDG_STATE_HOME": "state",
               "XDG_RUNTIME_DIR": "runtime", "TMPDIR": "tmp"}
    for folder in folders.values():
        (home / folder).mkdir(mode=0o700, exist_ok=True)
    kept = {name: os.environ[name] for name in ("PATH", "LD_LIBRARY_PATH", "ASAN_OPTIONS", "TSAN_OPTIONS") if name in os.environ}
    return kept | {name: str(home / folder) for name, folder in folders.items()} | {"QT_QPA_PLATFORM": "offscreen", "LC_ALL": "C.UTF-8"}


def written_in(folder):
    return sorted(str(path.relative_to(folder)) for path in folder.rglob("*") if not path.is_dir())


def make_read_only(but):
    """All that is mounted, but for one folder; within a mount namespace of its own."""
    subprocess.run(["mount", "--bind", but, but], check=True)
    for line in pathlib.Path("/proc/self/mountinfo").read_text().splitlines():
        place = line.split()[4].encode().decode("unicode_escape")
        if place != but and not place.startswith(("/proc", "/sys", "/dev")):
            subprocess.run(["mount", "-o", "remount,bind,ro", place], capture_output=True)
    try:
        pathlib.Path(__file__).with_name("written").touch()
    except OSError:
        return
    sys.exit("The source is not read-only.")


def inside(root, cli, window, folder):
    """Runs in a namespace without network."""
    faults = []
    make_read_only(str(folder))
    home, here = folder / "home", folder / "here"
    home.mkdir()
    here.mkdir()
    environment = surroundings(home)
    for name, text in (("study.json", STUDY), ("strip.csv", STRIP), ("yarns.csv", YARNS), ("panel.obj", PANEL)):
        (folder / name).write_text(text)
    named_verbs = {str(arguments[0]) for arguments, _ in verbs(root)}
    shown = subprocess.run([cli, "--help"], env=environment, capture_output=True, text=True, check=True).stdout
    listed = set(re.findall(r"^  ([a-z]+) ", shown.partition("Subcommands:")[2], re.MULTILINE))
    if not {"check", "simulate", "verify"} <= listed or listed - named_verbs:
        faults.append(f"--help lists {sorted(listed)}; of these are not called: {sorted(listed - named_verbs)}")
    named = set()
    for arguments, writes in verbs(root):
        answer = subprocess.run([cli, *map(str, arguments)], cwd=here, env=environment, capture_output=True, text=True, timeout=120)
        if answer.returncode != 0:
            faults.append(f"{arguments[0]} ends with {answer.returncode}: {answer.stderr.strip()[-300:]}")
        named |= set(writes)
        found = {path.name for path in here.iterdir()}
        if found != named:
            faults.append(f"{arguments[0]} writes {sorted(found - named)} besides, and not {sorted(named - found)}")
    if [name for name in written_in(home) if name != "cache/hygroloom/times.json" and not name.startswith("cache/hygroloom/rooms/")]:
        faults.append(f"The verbs write {written_in(home)} in the home folder.")
    if window:
        # It runs until it is ended.
        try:
            answer = subprocess.run([window, here / "imported.hygro"], cwd=here, env=environment, capture_output=True, text=True, timeout=4)
            faults.append(f"The window ends with {answer.returncode}: {answer.stderr[-300:]}")
        except subprocess.TimeoutExpired:
            pass
        faults += [f"The window writes {name}" for name in written_in(home) if not re.match(r"(config|data|cache)/hygroloom/", name)]
        if {path.name for path in here.iterdir()} != named:
            faults.append("The window writes into its working folder.")
    if faults:
        sys.exit("\n".join(faults))
    print(f"{len(verbs(root))} calls without network, all but one folder read-only; the window {'wrote ' + ', '.join(written_in(home)) if window else 'was not tried'}.")


def main():
    linked_only = sys.argv[1] == "--linked-only"
    cli, *rest = sys.argv[3 if linked_only else 2:]
    window = rest[0] if rest else None
    if faults := [fault for program in (cli, window) if program for fault in linked_faults(program)] + called_faults(cli):
        sys.exit("\n".join(faults))
    if linked_only:
        return 0
    apart = ["unshare", "--map-root-user", "--net", "--mount"]
    if not shutil.which("unshare") or subprocess.run([*apart, "true"], capture_output=True).returncode != 0:
        print("SKIPPED: unshare may not make a namespace without network here; only the linked libraries were looked at.")
        return SKIPPED
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([*apart, sys.executable, __file__, *sys.argv[1:], "--inside", os.path.realpath(folder)])
    return done.returncode


if "--inside" in sys.argv:
    at = sys.argv.index("--inside")
    inside(pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3] if at > 3 else None, pathlib.Path(sys.argv[at + 1]))
else:
    sys.exit(main())
