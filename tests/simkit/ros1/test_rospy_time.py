"""rospy: time, sleeping, rates and timers."""

import pytest

ARITHMETIC = {
    "time and duration": ("rospy.Time(5) + rospy.Duration(2.5)", "7500000000"),
    "duration and time": ("rospy.Duration(2.5) + rospy.Time(5)", "7500000000"),
    "times differ by a duration": ("(rospy.Time(5) - rospy.Time(7)).to_sec()", "-2.0"),
    "seconds and nanoseconds": ("rospy.Time(1, 500).to_nsec()", "1000000500"),
    "from seconds": ("rospy.Time.from_sec(1.25).nsecs", "250000000"),
    "old name": ("rospy.Time.from_seconds(1.5).to_sec()", "1.5"),
    "zero": ("rospy.Time(0).is_zero(), rospy.Time() == rospy.Time(0)", "True True"),
    "sum": ("(rospy.Duration(1) + rospy.Duration(0.5)).to_sec()", "1.5"),
    "scaled": ("(rospy.Duration(1.5) * 2).to_sec()", "3.0"),
    "halved": ("(rospy.Duration(3) / 2).to_sec()", "1.5"),
    "negated": ("(-rospy.Duration(1.5)).to_sec()", "-1.5"),
    "compared": (
        "rospy.Time(2) > rospy.Time(1) and rospy.Duration(1) <= rospy.Duration(1)",
        "True",
    ),
    "hashed": ("len({rospy.Time(1), rospy.Time(1.0)})", "1"),
    "shown": (
        "repr(rospy.Time(1)), repr(rospy.Duration(1))",
        "rospy.Time[1000000000] rospy.Duration[1000000000]",
    ),
    "string": ("str(rospy.Time(1)) + ' ' + str(rospy.Duration(-1))", "1000000000 -1000000000"),
    "plain result": ("type(rospy.Time(1) + rospy.Duration(1)).__name__", "Time"),
    "genpy": ("__import__('genpy').Time(1) == rospy.Time(1)", "True"),
    "now is a rospy time": ("type(rospy.Time.now()) is rospy.Time", "True"),
    "three clocks": (
        "rospy.get_rostime().to_sec() == rospy.get_time() == rospy.Time.now().to_sec()",
        "True",
    ),
    "not the wall": ("rospy.rostime.is_wallclock()", "False"),
    "initialized": ("rospy.rostime.is_rostime_initialized()", "True"),
}


@pytest.mark.parametrize(("expression", "shown"), ARITHMETIC.values(), ids=ARITHMETIC)
def test_arithmetic(prints, expression, shown):
    assert prints(f"rospy.init_node('x'); print({expression})").strip() == shown


ERRORS = {
    "before the epoch": (
        "rospy.Time(3) - rospy.Duration(5.0)",
        "TypeError: time values must be positive",
    ),
    "times do not add": ("rospy.Time(1) + rospy.Time(1)", "TypeError: unsupported operand"),
    "nor numbers": ("rospy.Time(1) + 1", "TypeError: unsupported operand"),
    "nor the other way": ("rospy.Time(1) - 0.5", "TypeError: unsupported operand"),
    "nor compare": ("rospy.Time(1) > rospy.Duration(1)", "TypeError: '>' not supported"),
    "floats have no nanoseconds": (
        "rospy.Duration(1.5, 1)",
        "ValueError: if secs is a float, nsecs cannot be set",
    ),
    "no rate": ("rospy.Rate(0)", "ZeroDivisionError"),
    "a period is a duration": (
        "rospy.Timer(0.5, print)",
        "TypeError: a Timer's period is a rospy.Duration, not 0.5",
    ),
}


@pytest.mark.parametrize(("expression", "error"), ERRORS.values(), ids=ERRORS)
def test_errors(run_script, expression, error):
    node = run_script(f"import rospy\nrospy.init_node('x')\n{expression}\n", seconds=0.1)
    assert error in node.failure.text
    assert node.failure.line == 3


def test_sleeps(prints):
    text = """
        rospy.init_node('x')
        for duration in (0.5, 2, rospy.Duration(1.5), rospy.Duration(0, 1), -3, rospy.Duration(-1)):
            before = rospy.Time.now()
            rospy.sleep(duration)
            print((rospy.Time.now() - before).to_nsec())
        """
    expected = [500_000_000, 2_000_000_000, 1_500_000_000, 1, 0, 0]
    assert [int(line) for line in prints(text).split()] == expected


def test_a_rate_counts_the_time_of_the_loop_in(prints):
    text = """
        rospy.init_node('x')
        rate, start = rospy.Rate(10), rospy.Time.now()
        for work in (0.0, 0.04, 0.09, 0.0):
            rospy.sleep(work) if work else None
            print(round(rate.remaining().to_sec(), 3), end=' ')
            rate.sleep()
            print(round((rospy.Time.now() - start).to_sec(), 3))
        """
    assert prints(text) == "0.1 0.1\n0.06 0.2\n0.01 0.3\n0.1 0.4\n"


def test_a_rate_that_fell_behind_catches_up_or_starts_anew(prints):
    text = """
        rospy.init_node('x')
        rate, start = rospy.Rate(10), rospy.Time.now()
        for work in (0.15, 0.0, 0.0, 0.55, 0.0, 0.0):
            if work:
                rospy.sleep(work)
            rate.sleep()
            print(round((rospy.Time.now() - start).to_sec(), 3))
        """
    # 0.15: late, the next turn is short; 0.55: later than two turns, so the beat begins anew.
    assert prints(text).split() == ["0.15", "0.2", "0.3", "0.85", "0.95", "1.05"]


def test_a_loop_on_is_shutdown_alone_lets_a_millisecond_pass(prints):
    text = """
        rospy.init_node('x')
        start, turns = rospy.Time.now(), 0
        while not rospy.is_shutdown() and turns < 50:
            turns += 1
        print((rospy.Time.now() - start).to_sec())
        """
    assert float(prints(text)) == pytest.approx(0.05, abs=0.002)


@pytest.mark.parametrize(
    "condition",
    [
        "publisher.get_num_connections() < 1",
        "not rospy.has_param('/ready')",
        "rospy.get_param('/ready', None) is None",
        "not [t for t in rospy.get_published_topics() if t[0] == '/ready']",
        "rospy.Time.now() - start < rospy.Duration(2)",
        "rospy.get_time() - start.to_sec() < 2",
    ],
)
def test_a_loop_that_only_asks_lets_time_pass(prints, sim, condition):
    def be_ready():
        sim.params.set("/ready", True)
        node = sim.graph.create_node("/late")
        node.advertise("/ready", message)
        node.subscribe("/words", message, print)

    from simkit.msgs import message_class

    message = message_class("std_msgs/String")
    sim.graph.executor.call_at(sim.graph.executor.now_ns + 2 * 10**9, be_ready)
    output = prints(
        f"""
        from std_msgs.msg import String
        rospy.init_node('x')
        publisher, start = rospy.Publisher('/words', String, queue_size=1), rospy.Time.now()
        while {condition}:
            pass
        print(rospy.get_time() - start.to_sec())
        """
    )
    assert float(output) == pytest.approx(2.0, abs=0.01)


def test_a_timer_tells_when_it_should_and_did_come(prints):
    text = """
        rospy.init_node('x')
        start, events = rospy.Time.now(), []
        def tick(event):
            events.append(event)
            if len(events) == 1:
                rospy.sleep(0.25)
        timer = rospy.Timer(rospy.Duration(0.1), tick)
        rospy.sleep(0.55)
        timer.shutdown()
        rospy.sleep(0.5)
        def since(stamp):
            return None if stamp is None else round((stamp - start).to_sec(), 3)
        for e in events:
            print(since(e.last_expected), since(e.last_real), since(e.current_expected), since(e.current_real),
                  e.last_duration)
        timer.join()
        print(timer.is_alive())
        """
    assert prints(text).splitlines() == [
        "None None 0.1 0.1 None",
        "0.1 0.1 0.2 0.35 0.25",
        "0.2 0.35 0.3 0.35 0.0",
        "0.3 0.35 0.4 0.4 0.0",
        "0.4 0.4 0.5 0.5 0.0",
        "False",
    ]


def test_a_timer_that_was_held_up_long_begins_its_beat_anew(prints):
    text = """
        rospy.init_node('x')
        start, times = rospy.get_time(), []
        def tick(event):
            times.append(round(rospy.get_time() - start, 3))
            if len(times) == 1:
                rospy.sleep(0.95)
        timer = rospy.Timer(rospy.Duration(0.1), tick)
        rospy.sleep(1.3)
        print(times)
        """
    assert prints(text) == "[0.1, 1.05, 1.15, 1.25]\n"


def test_a_oneshot_timer_comes_once(prints):
    text = """
        rospy.init_node('x')
        timer = rospy.Timer(rospy.Duration(0.5), lambda event: print('once'), oneshot=True)
        rospy.sleep(3)
        """
    assert prints(text) == "once\n"


def test_a_timer_whose_callback_fails_stops_and_the_node_goes_on(sim, run_script):
    node = run_script(
        """
        import rospy
        rospy.init_node('x')
        def tick(event):
            raise RuntimeError('broken')
        rospy.Timer(rospy.Duration(0.1), tick)
        rospy.sleep(1)
        print('main goes on')
        """,
        seconds=2,
    )
    assert node.output.endswith("main goes on\n")
    assert node.failure.line == 4
    assert sum("bad callback" in record.text for record in sim.log) == 1


def test_a_timer_and_the_main_thread_take_turns(prints):
    text = """
        rospy.init_node('x')
        seen = []
        rospy.Timer(rospy.Duration(0.3), lambda event: seen.append('timer'))
        for _ in range(4):
            rospy.sleep(0.2)
            seen.append('main')
        print(*seen)
        """
    assert prints(text) == "main timer main timer main main\n"
