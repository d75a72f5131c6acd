"""Every clock and every die of a script is the simulation's."""

import pytest

START = 1_600_088_400


@pytest.mark.parametrize(
    ("expression", "value"),
    [
        ("time.time() - START", 1.5),
        ("time.time_ns() - START * 10**9", 1_500_000_000),
        ("time.monotonic() - START", 1.5),
        ("time.perf_counter_ns() - START * 10**9", 1_500_000_000),
        ("time.process_time() - START", 1.5),
        ("time.clock_gettime(time.CLOCK_REALTIME) - START", 1.5),
        ("datetime.datetime.now().isoformat()", "2020-09-14T13:00:01.500000"),
        ("datetime.datetime.utcnow().isoformat()", "2020-09-14T13:00:01.500000"),
        ("datetime.datetime.today().second", 1),
        ("datetime.datetime.now(datetime.timezone.utc).isoformat()[-6:]", "+00:00"),
        ("datetime.date.today().isoformat()", "2020-09-14"),
        ("time.strftime('%H:%M:%S')", "13:00:01"),
        ("time.ctime()", "Mon Sep 14 13:00:01 2020"),
        ("time.localtime().tm_hour", 13),
        ("time.gmtime(0).tm_year", 1970),
        ("type(datetime.datetime.now()).__name__", "datetime"),
        ("isinstance(datetime.datetime(2020, 1, 1), datetime.datetime)", True),
        ("isinstance(datetime.datetime.now() + datetime.timedelta(1), datetime.datetime)", True),
        ("(datetime.datetime(2020, 9, 15) - datetime.datetime.now()).days", 0),
    ],
)
def test_clocks(run_script, expression, value):
    node = run_script(
        f"""
        import datetime, time
        START = {START}
        time.sleep(1.5)
        print(repr({expression}))
        """,
        seconds=2,
    )
    assert node.failure is None
    shown = eval(node.output)
    assert shown == pytest.approx(value) if isinstance(value, float) else shown == value


def test_a_sleep_is_exact_and_a_negative_one_is_no_sleep(run_script):
    node = run_script(
        """
        import time
        start = time.time_ns()
        for seconds in (0.25, 1e-9, 3600, 0):
            before = time.time_ns()
            time.sleep(seconds)
            print(time.time_ns() - before)
        """,
        seconds=3602,
    )
    assert [int(line) for line in node.output.split()][:3] == [250_000_000, 1, 3_600_000_000_000]


def test_reading_the_clock_costs_nothing_until_it_is_a_loop(run_script):
    node = run_script(
        """
        import time
        readings = [time.time() for _ in range(20)]
        print(len(set(readings)))
        while time.time() - readings[0] < 0.01:
            pass
        print('passed')
        """,
        seconds=0.1,
    )
    assert node.output == "1\npassed\n"


def test_dice_depend_on_seed_and_node_only(package):
    from simkit import Simulation

    text = """
        import random
        import numpy as np
        print(random.random(), np.random.rand(), random.sample(range(100), 3), hash('x'))
        """
    package("one.py", text)
    package("two.py", text)

    def roll(seed, name, *arguments):
        with Simulation(seed, package_path=[package.folder], screen=None) as sim:
            node = sim.rosrun("play", name, *arguments)
            sim.run(0.1)
            return node.output

    first = roll(1, "one.py")
    assert first == roll(1, "one.py")
    assert len({first, roll(2, "one.py"), roll(1, "two.py"), roll(1, "one.py", "other")}) == 4
