"""The command line: one module per command, imported when it is called."""

from __future__ import annotations

import importlib
import sys
from typing import Any

import click

#: Command -> what it does, in one line. The module of the same name holds `command`.
COMMANDS = {
    "study": "Every table and figure of Brott's thesis, computed and compared.",
}


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
            from ..errors import unknown

            raise click.UsageError(str(unknown("command", args[0], COMMANDS)), ctx)
        return super().resolve_command(ctx, args)


@click.command(cls=_LazyGroup, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(package_name="groundloop")
def _group() -> None:
    """Ground stability of light aircraft: where may the wheels stand?"""


def main(arguments: list[str] | None = None) -> Any:
    """Run the command line.

    Exit codes: 0 done, 1 it cannot be done (the message says why), 2 wrong usage, 130 interrupted.
    """
    from ..errors import GroundloopError

    try:
        return _group.main(args=arguments, standalone_mode=False)
    except GroundloopError as problem:
        click.echo(f"groundloop: {problem}", err=True)
        sys.exit(1)
    except click.ClickException as problem:
        problem.show()
        sys.exit(problem.exit_code)
    except (click.Abort, KeyboardInterrupt):
        click.echo("groundloop: interrupted", err=True)
        sys.exit(130)
