"""The command line: one module per command, imported when it is called.

Results go to stdout, everything else to stderr. Exit codes, for scripts:

====  =====================================================================================
0     done; also an honest "there is none"
1     it cannot be done, and the message says why: a file with mistakes, a value that cannot
      be, a folder that cannot be written; `check` of an aircraft that no model can run
2     wrong usage: an unknown command, option, parameter name or unit
130   interrupted
143   ended from outside (SIGTERM; 129: SIGHUP)
====  =====================================================================================
"""

from __future__ import annotations

import importlib
import os
import sys
import warnings
from typing import Any

import click

#: Command -> what it does, in one line. The module of the same name holds `command`.
COMMANDS = {
    "simulate": "The ground roll after a disturbance, with a picture.",
    "linearize": "State-space matrices and modes at an operating point.",
    "trim": "Every steady turn under a side force.",
    "map": "A stability margin over any two parameters, with a picture.",
    "place": "Where the main gear should stand, within limits.",
    "ensemble": "Many ground rolls at once, with a picture: a grid or a draw.",
    "survival": "How hard a kick it survives, beside what the linear model says.",
    "hold": "What can be held: crosswind and the delay of a pilot.",
    "check": "What an aircraft file says, what follows, what is missing.",
    "new": "An aircraft file to fill in.",
    "import": "An aircraft file from JSBSim's, and AVL's stability derivatives.",
    "fit-tire": "Parameters of the non-linear tire from measured forces.",
    "derive": "A model of your own: from a parts list to a folder of compiled code.",
    "explore": "A page to play with an aircraft in any browser, in one file.",
    "export": "A model with an aircraft's numbers for other programs: C, FMI.",
    "study": "Every table and figure of Brott's thesis, computed and compared.",
    "info": "Versions, packaged aircraft and tires, models.",
}

_EPILOG = (
    "AIRCRAFT is a packaged aircraft or a TOML file; any quantity may have a unit ('100 km/h')."
    ' Completion: eval "$(_GROUNDROLL_COMPLETE=bash_source groundroll)", or zsh_source.'
)


class _LazyGroup(click.Group):
    """Lists the commands without importing them: `--help` must be quick."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, name: str) -> click.Command | None:
        if name not in COMMANDS:
            return None
        module = importlib.import_module(f"{__name__}.{name.replace('-', '_')}")
        command: click.Command = module.command
        return command

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        with formatter.section("Commands"):
            formatter.write_dl(list(COMMANDS.items()))

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        if args and args[0] not in COMMANDS:
            from groundroll.base.errors import unknown

            raise click.UsageError(str(unknown("command", args[0], COMMANDS)), ctx)
        return super().resolve_command(ctx, args)


@click.command(
    cls=_LazyGroup,
    context_settings={"help_option_names": ["-h", "--help"]},
    epilog=_EPILOG,
)
@click.version_option(package_name="groundroll")
def _group() -> None:
    """Ground stability of light aircraft: where may the wheels stand?"""


def main(arguments: list[str] | None = None) -> int:
    """Run the command line and return its exit code, one of those above."""
    from groundroll.base.errors import GroundrollError
    from groundroll.base.interruption import ended, interruptible

    from .output import drop_stdout

    if "matplotlib" not in sys.modules:  # whose import fails if this names none of its own
        os.environ["MPLBACKEND"] = "agg"
    with warnings.catch_warnings(), ended() as by:
        warnings.showwarning = _show_warning
        try:
            with interruptible():
                found = _group.main(arguments, prog_name="groundroll", standalone_mode=False)
            return found or 0
        except click.ClickException as problem:
            return _failed(problem.format_message(), problem.exit_code, _usage(problem))
        except (click.Abort, KeyboardInterrupt):
            return _failed(*(("ended", 128 + by[0]) if by else ("interrupted", 130)))
        except BrokenPipeError:
            drop_stdout()
            return 1
        except GroundrollError as problem:
            return _failed(str(problem), 1)
        except MemoryError:
            return _failed("there is not enough memory for this", 1)
        except OSError as problem:  # --help goes to a stdout that is full
            drop_stdout()
            return _failed(str(problem), 1)


def _usage(problem: click.ClickException) -> str:
    """How the command is called that was called in another way."""
    context = getattr(problem, "ctx", None)
    if context is None:
        return ""
    hint = f"Try '{context.command_path} --help' for help.\n"
    return f"{context.get_usage()}\n{hint}\nError: "


def _failed(message: str, code: int, head: str = "groundroll: ") -> int:
    from .output import say

    say(f"{head}{message}")
    return code


def _show_warning(message: Warning | str, *_: Any, **__: Any) -> None:
    from .output import say

    say(f"groundroll: warning: {message}")
