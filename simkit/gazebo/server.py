"""The world on the clock of a simulation: models come and go, time passes and stops.

Source: gazebo_ros `gazebo_ros_api_plugin.cpp`: statuses and logs of spawning and deleting.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType

from simkit.diagnostics import Severity
from simkit.errors import SimkitError
from simkit.gazebo.models import Spawned, SpawnError
from simkit.gazebo.plugin_loader import Attachments, tags_of_robot, tags_of_sdf
from simkit.geometry import Transform
from simkit.graph import Node
from simkit.packages import PackagePath
from simkit.physics import ORIGIN, LostModelError, Model, ModelPlan, World, plan_robot
from simkit.physics.sdf import ModelLibrary, SdfModel, SdfWorld, plan_model, read_model_text
from simkit.urdf import load_robot, read_robot
from simkit.urdf.rules.check import brief_lines

WORLD_FRAMES = ("", "world", "map", "/map")
"""Names of reference frames that mean the world."""
EXISTS = "SpawnModel: Failure - entity already exists."
NO_FRAME = "SpawnModel: reference reference_frame not found, did you forget to scope the link by model name?"
INVALID = "SpawnModel: Failure - entity format is invalid."


class Gazebo:
    """A world, joined to the graph of a simulation.

    Args:
        node: The node `/gazebo`.
        packages: Where meshes, models and world files are.
        description: The world file.
        paused: Whether it begins at rest.
    """

    def __init__(
        self,
        node: Node,
        packages: PackagePath,
        *,
        description: SdfWorld,
        paused: bool = False,
    ) -> None:
        self.node = node
        self.packages = packages
        self.world = World(gravity=description.gravity, ground=False, step_ns=description.step_ns)
        self.on_spawn: list[Callable[[Spawned], None]] = []
        self.on_delete: list[Callable[[Spawned], None]] = []
        self.before_run: list[Callable[[], None]] = []
        """Called whenever the world is about to move on: who needs its hooks may put them in or out here."""
        self.paused = paused
        self._spawned: dict[str, Spawned] = {}
        self._attachments = Attachments(node, self.world, lambda: self._base_ns)
        self._executor = node.graph.executor
        self._base_ns = self._executor.now_ns
        self.world.tell_time(self._passed)
        self._executor.attach(self._move)
        node.on_shutdown(self._close)
        for model in description.models:
            self._add_sdf(model, model.name, model.pose.transform, None, model.uri)

    @property
    def spawned(self) -> Mapping[str, Spawned]:
        """The models by name, the oldest first; those of the world file are among them, the ground too."""
        return MappingProxyType(self._spawned)

    # -- models come and go

    def spawn_urdf(
        self,
        text: str,
        *,
        name: str,
        pose: Transform = ORIGIN,
        namespace: str | None = "/",
        reference_frame: str = "",
        file: str = "",
    ) -> Spawned:
        """Bring a robot into the world.

        Args:
            text: Its URDF.
            name: Its name in the world.
            pose: Where its root link shall be, in the reference frame.
            namespace: Where the names of its plugins are that say nothing of it; the model's name if None.
            reference_frame: A model, or `model::link`; the world if empty.
            file: Name to show for the URDF.

        Raises:
            SpawnError: There is a model of that name, no such frame, or nothing that can be simulated.
        """
        at = self._placed(name, pose, reference_frame)
        self._log_faults(text, file or name)
        try:
            robot = load_robot(text, file=file or name, packages=self.packages)
            plan = plan_robot(robot)
        except SimkitError as error:
            raise SpawnError(INVALID, str(error)) from None
        root = robot.document.root
        origin = None if root is None else root.child("origin")
        if origin is not None:
            self.node.warn(
                f"{file or name}:{origin.span.line}: <origin> of <robot> is not read; give the pose when you spawn"
            )
        model = self._add(plan, name, at)
        plugins = self._attachments.attach(
            tags_of_robot(robot), model, robot=robot, file=file or name, namespace=namespace
        )
        found = Spawned(name=name, model=model, robot=robot, plugins=plugins, namespace=namespace)
        return self._welcome(found)

    def spawn_sdf(
        self,
        text: str,
        *,
        name: str,
        pose: Transform = ORIGIN,
        namespace: str | None = "/",
        reference_frame: str = "",
        file: str = "",
    ) -> Spawned:
        """Bring a model of SDF into the world; see `spawn_urdf`.

        Raises:
            SpawnError: As `spawn_urdf`.
        """
        at = self._placed(name, pose, reference_frame)
        try:
            model, found = read_model_text(
                text, file=file or name, library=ModelLibrary(packages=self.packages)
            )
        except SimkitError as error:
            raise SpawnError(INVALID, str(error)) from None
        for one in found:
            if one.severity is not Severity.NOTE:
                self.node.warn(f"{one.file}:{one.span.line}: {one.what}")
        return self._add_sdf(model, name, at @ model.pose.transform, namespace, file)

    def delete(self, name: str) -> None:
        """Take a model out of the world.

        Raises:
            UnknownNameError: There is none of that name.
        """
        model = self.world.model(name)
        self._forget(name)
        self.world.remove(model.name)

    # -- time

    def pause(self) -> None:
        """Let the world stand still; the clock of the simulation goes on."""
        self.paused = True

    def unpause(self) -> None:
        """Let the world go on from where it stands."""
        if self.paused:
            self.paused = False
            self._rebase()

    def reset_world(self) -> None:
        """Put each model back where it came in, at rest."""
        self.world.reset(time=False)
        self._reset_plugins()

    def reset_simulation(self) -> None:
        """As `reset_world`, and the world's own time begins anew.

        The clock of the simulation never goes back.
        """
        self.world.reset()
        self._rebase()
        self._reset_plugins()

    def frame(self, name: str) -> Transform:
        """Where a model, or a link written as `model::link`, is in the world.

        Raises:
            SpawnError: There is none.
        """
        if name in WORLD_FRAMES:
            return ORIGIN
        model_name, _, link = name.partition("::")
        models = self.world.models
        if model_name in models and not link:
            return models[model_name].pose
        if model_name in models and link in models[model_name].links:
            return models[model_name].link_pose(link)
        known = ", ".join(models) or "none"
        raise SpawnError(NO_FRAME, f"There is no {name!r}; models here: {known}.")

    # -- private

    def _placed(self, name: str, pose: Transform, reference_frame: str) -> Transform:
        if not name:
            raise SpawnError(INVALID, "A model needs a name: -model NAME.")
        if name in self.world.models:
            raise SpawnError(
                EXISTS,
                f"A model {name!r} is there already: delete it first (rosservice call "
                f"/gazebo/delete_model '{{model_name: {name}}}'), or give another name.",
            )
        return self.frame(reference_frame) @ pose

    def _log_faults(self, text: str, file: str) -> None:
        """Log what check_urdf finds, once for each text."""
        reading = read_robot(text, file=file, packages=self.packages)
        if reading.is_first_report_to(self.node.graph):
            for line in brief_lines(reading, is_file=False):
                self.node.warn(line)

    def _add(self, plan: ModelPlan, name: str, pose: Transform) -> Model:
        try:
            model = self.world.add(plan, name=name, pose=pose)
        except SimkitError as error:
            raise SpawnError(INVALID, str(error)) from None
        if not plan.bodies:
            self.node.warn(
                f"{name} is an empty model: none of its links has a mass, so Gazebo simulates none of them"
            )
        return model

    def _add_sdf(
        self, sdf: SdfModel, name: str, pose: Transform, namespace: str | None, file: str
    ) -> Spawned:
        try:
            plan = plan_model(sdf)
        except SimkitError as error:
            raise SpawnError(INVALID, str(error)) from None
        model = self._add(plan, name, pose)
        plugins = self._attachments.attach(
            tags_of_sdf(sdf), model, robot=None, file=file or name, namespace=namespace
        )
        return self._welcome(
            Spawned(name=name, model=model, sdf=sdf, plugins=plugins, namespace=namespace)
        )

    def _welcome(self, spawned: Spawned) -> Spawned:
        self._spawned[spawned.name] = spawned
        for note in spawned.model.notes:
            self.node.debug(f"{spawned.name}: {note}")
        for call in tuple(self.on_spawn):
            call(spawned)
        return spawned

    def _forget(self, name: str) -> None:
        spawned = self._spawned.pop(name, None)
        if spawned is None:
            return
        for plugin in spawned.plugins:
            self._attachments.detach(plugin)
        for call in tuple(self.on_delete):
            call(spawned)

    def _reset_plugins(self) -> None:
        for spawned in self._spawned.values():
            for plugin in spawned.plugins:
                plugin.on_reset()

    def _rebase(self) -> None:
        self._base_ns = self._executor.now_ns - self.world.time_ns

    def _passed(self, time_ns: int) -> None:
        self._executor.pass_time(self._base_ns + time_ns)

    def _move(self, until_ns: int) -> None:
        """Make the steps that end until then, unless something comes up before."""
        if self.paused:
            return
        for call in tuple(self.before_run):
            call()
        lost = True
        while lost:
            lost = False
            try:
                self.world.run_until(until_ns - self._base_ns, stop=self._executor.has_due)
            except LostModelError as error:
                lost = not self._executor.has_due()
                self.node.error(str(error))
                self._forget(error.model)

    def _close(self) -> None:
        self._executor.attach(None)
        for name in tuple(self._spawned):
            self._forget(name)
