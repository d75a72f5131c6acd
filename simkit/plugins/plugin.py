"""What a plugin is: parameters, and hooks that the world calls."""

from __future__ import annotations

from typing import Any, ClassVar, Generic, TypeVar

from simkit.plugins.site import Site

HOOKS = ("on_attach", "before_step", "after_step", "on_reset", "on_detach")
"""All hooks; a method of such a name is called by the world, and no other name looks like one."""
_PREFIXES = ("on_", "before_", "after_")

NEVER = 2**62
"""Later than any time of a simulation [ns]."""

ParametersT = TypeVar("ParametersT")


class Plugin(Generic[ParametersT]):
    """One plugin at work; a subclass says in `Parameters` what its tag may say, and overrides hooks.

    Before a step and after it the clock of the graph shows the beginning of the step and its end; the
    model stands as it does at that time. Hooks of several plugins run in the order of their tags.

    Args:
        site: Where it works.
        parameters: What its tag says.

    Raises:
        PluginError: It cannot work here.
    """

    Parameters: ClassVar[type[Any]]
    """A frozen dataclass whose fields are made by `simkit.plugins.parameters.tag`."""

    def __init_subclass__(cls, **kwargs: Any) -> None:
        """Refuse a method that looks like a hook and is none: nobody would ever call it."""
        super().__init_subclass__(**kwargs)
        for name in vars(cls):
            if name.startswith(_PREFIXES) and name not in HOOKS:
                raise TypeError(f"{cls.__name__}.{name} is no hook; these are: {', '.join(HOOKS)}")

    def __init__(self, site: Site, parameters: ParametersT) -> None:
        self.site = site
        self.parameters = parameters

    def on_attach(self) -> None:
        """The model is in the world: advertise, subscribe, look joints up."""

    def before_step(self) -> None:
        """A step begins."""

    def after_step(self) -> None:
        """A step has been made."""

    @property
    def due_ns(self) -> int:
        """Time of the graph from which on the hooks of a step have something to do [ns]; `NEVER` for never.

        A plugin that works so many times a second says it, and the engine makes the steps in between
        without Python. One that does not say it is called in each step.
        """
        return 0

    def on_reset(self) -> None:
        """The world was put back to its beginning; the clock goes on."""

    def on_detach(self) -> None:
        """The model leaves the world: withdraw from topics and services, let go of joints."""

    @classmethod
    def speaker(cls, site: Site) -> str | None:  # noqa: ARG003 - for those that override it
        """Who says which tags are missing, and their defaults; None for a plugin that does not say."""
        return None

    @classmethod
    def overrides(cls, hook: str) -> bool:
        """Whether it does something at a hook; only then is it called."""
        return getattr(cls, hook) is not getattr(Plugin, hook)
