"""Operations of each generated function, and bytes and accesses to the stack of its machine code."""

import re
import shutil
import subprocess

COUNTED = re.compile(r"^/// (\d+) operations: .*\n(?:///.*\n|#\[.*\n)*pub fn (\w+)\(", re.M)
HEAD = re.compile(r"^([0-9a-f]+) <(.+)>:$")
CALL = re.compile(r"\b(?:call|jmp)q?\s+[0-9a-f]+ <([^>+]+)>")
STACK = re.compile(r"\(%[er]sp")


class Symbol:
    def __init__(self):
        self.bytes, self.instructions, self.stack, self.calls = 0, 0, 0, set()


def symbols(program, package):
    """Every function of a package, by its readable name."""
    command = ["objdump", "--disassemble", "--no-show-raw-insn", "--demangle", program]
    found, current, start = {}, None, 0
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as listing:
        for line in listing.stdout:
            head = HEAD.match(line)
            if head:
                mine = package in head[2]
                current = found.setdefault(head[2], Symbol()) if mine else None
                start = int(head[1], 16)
            elif current and ":\t" in line:
                place, _, text = line.partition(":\t")
                current.bytes = int(place, 16) - start  # but for its last instruction
                current.instructions += 1
                current.stack += bool(STACK.search(text))
                call = CALL.search(text)
                if call:
                    current.calls.add(call[1])
    return found


def reach(found, name):
    """A function with all that it calls."""
    seen, ahead = set(), [name]
    while ahead:
        one = ahead.pop()
        if one in found and one not in seen:
            seen.add(one)
            ahead.extend(found[one].calls)
    parts = [found[one] for one in seen]
    if not parts:
        return {}
    total = lambda of: sum(getattr(part, of) for part in parts)
    return {"bytes": total("bytes"), "stack": round(total("stack") / total("instructions"), 3)}


def of(program, name, texts):
    """{form: {quantity: {operations, bytes, stack}}}"""
    found = symbols(program, f"code_{name}") if shutil.which("objdump") else {}
    counted = lambda text: {function: int(count) for count, function in COUNTED.findall(text)}
    return {
        form: {
            function: {"operations": count} | reach(found, f"code_{name}::{form}::{function}")
            for function, count in counted(text).items()
        }
        for form, text in texts.items()
    }
