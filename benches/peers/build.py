"""Compiles the programs that take part; each is compiled again when what it is made of changes."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
# Of Pinocchio's own CMake files.
BOOST = ["-DBOOST_MPL_LIMIT_LIST_SIZE=30", "-DBOOST_MPL_LIMIT_VECTOR_SIZE=30", "-DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS",
         "-DBOOST_FUSION_INVOKE_MAX_ARITY=12"]
FOR_THIS_PROCESSOR = ["-O3", "-march=native", "-DNDEBUG"]


def stop(message):
    print(f"peers: {message}", file=sys.stderr)
    sys.exit(2)


def say(message):
    print(f"peers: {message}", file=sys.stderr, flush=True)


def clang():
    """The newest clang++, or what CXX names."""
    named = os.environ.get("CXX")
    candidates = [named] if named else ["clang++", *(f"clang++-{version}" for version in range(30, 13, -1))]
    found = next((name for name in candidates if shutil.which(name)), None)
    return found or stop("no clang++ found; on Debian: apt-get install clang (or set CXX)")


def compiled(output, sources, command):
    """Runs a compiler if a source is newer than its result."""
    output.parent.mkdir(parents=True, exist_ok=True)
    if output.exists() and all(output.stat().st_mtime > Path(source).stat().st_mtime for source in sources):
        return output
    say(f"compiling {output.name} with {command[0]}")
    done = subprocess.run([*command, "-o", output], stderr=subprocess.PIPE, text=True)
    if done.returncode:
        stop(f"{command[0]} could not compile {output.name}:\n{done.stderr[-4000:]}")
    return output


def pinocchio(folder, prefix):
    """Three programs of the same text: clang and gcc over the headers, and the wheel's own library."""
    source, serve = HERE / "pinocchio.cpp", HERE / "serve.hpp"
    common = ["-std=c++17", *BOOST, "-isystem", prefix / "include", "-isystem", prefix / "include/eigen3", source]
    library = ["-DPINOCCHIO_ENABLE_TEMPLATE_INSTANTIATION", f"-L{prefix}/lib", f"-Wl,-rpath,{prefix}/lib", "-lpinocchio_default"]
    made = {"pinocchio": [clang(), *FOR_THIS_PROCESSOR, *common]}
    if shutil.which("g++"):
        made["pinocchio_gcc"] = ["g++", *FOR_THIS_PROCESSOR, *common]
    # Compiled as the wheel is: an Eigen for another processor lays out its matrices differently.
    made["pinocchio_wheel"] = [clang(), "-O3", "-DNDEBUG", *common, *library]
    return {name: compiled(folder / name, [source, serve], command) for name, command in made.items()}


def mujoco(folder):
    """MuJoCo's functions are those of its library."""
    import mujoco

    package = Path(mujoco.__file__).parent
    library = next(package.glob("libmujoco.so*"))
    command = [clang(), "-std=c++17", *FOR_THIS_PROCESSOR, "-isystem", package / "include", HERE / "mujoco.cpp", library,
               f"-Wl,-rpath,{package}"]
    return compiled(folder / "mujoco", [HERE / "mujoco.cpp", HERE / "serve.hpp"], command)


def casadi(folder, name):
    """The program around the C that symbolic_works.py wrote into `folder`."""
    compiler = clang().replace("clang++", "clang")
    code = compiled(folder / "works.o", [folder / "works.c"], [compiler, *FOR_THIS_PROCESSOR, "-c", folder / "works.c"])
    command = [clang(), "-std=c++17", *FOR_THIS_PROCESSOR, f"-I{folder}", HERE / "casadi.cpp", code, "-lm"]
    return compiled(folder / f"casadi_{name}", [code, HERE / "casadi.cpp", HERE / "serve.hpp"], command)


def cargo(folder, target, *arguments):
    """Runs cargo for this processor, with the versions of our own lock file."""
    lock = folder / "Cargo.lock"
    if not lock.exists():
        shutil.copy(HERE.parents[1] / "Cargo.lock", lock)
    environment = os.environ | {"RUSTFLAGS": "-C target-cpu=native"}
    command = ["cargo", "build", "--release", "--target-dir", target, *arguments]
    if subprocess.run(command, cwd=folder, env=environment, stdout=sys.stderr).returncode:
        stop("our side did not build")
    return target / "release"
