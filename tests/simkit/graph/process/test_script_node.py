"""A script as a node: time, messages, services, parameters, its end and its faults."""

import os
import subprocess
import sys
import time
from pathlib import Path

import pytest

from simkit import Simulation
from simkit.graph.process import NodeLimits, NodeRuntime, Permissions

START = 1_600_088_400


def test_a_rate_loop_ticks_in_virtual_time(sim, run_script):
    record = sim.record({"/tick": "std_msgs/Float64"})
    node = run_script(
        """
        import rospy
        from std_msgs.msg import Float64
        rospy.init_node('ticker')
        pub = rospy.Publisher('/tick', Float64, queue_size=10)
        rate = rospy.Rate(10)
        while not rospy.is_shutdown():
            pub.publish(rospy.get_time())
            rate.sleep()
        """
    )
    sim.run(1.0)
    times = [message.data - START for _, message in record["/tick"]]
    assert times == pytest.approx([i / 10 for i in range(11)])
    assert [stamp.to_sec() for stamp, _ in record["/tick"]] == pytest.approx(
        [t + START for t in times]
    )
    assert node.alive
    assert node.name == "/ticker"


@pytest.mark.parametrize(
    "body", ["pass", "listener.lookupTransform('/a', '/b', rospy.Time(0))", "rospy.get_time()"]
)
def test_a_loop_that_never_sleeps_lets_time_pass(sim, run_script, body):
    run_script(
        f"""
        import rospy, tf
        rospy.init_node('busy')
        listener = tf.TransformListener()
        while not rospy.is_shutdown():
            try:
                {body}
            except tf.LookupException:
                continue
        """
    )
    sim.run(0.2)
    assert sim.now.to_sec() == pytest.approx(START + 0.2)


def test_a_loop_over_the_clock_ends(sim, run_script):
    node = run_script(
        """
        import rospy, time
        rospy.init_node('waiter')
        end = rospy.Time.now() + rospy.Duration(1.0)
        while rospy.Time.now() < end:
            pass
        start = time.time()
        while time.time() - start < 0.5:
            pass
        print('done at', rospy.get_time())
        """,
        seconds=2.0,
    )
    assert node.exit_code == 0
    done = float(node.output.split()[-1])
    assert done == pytest.approx(START + 1.5, abs=0.01)


def test_messages_reach_callbacks_with_arguments_in_order(sim, run_script):
    node = run_script(
        """
        import rospy
        from std_msgs.msg import Int32
        rospy.init_node('ear')
        rospy.Subscriber('numbers', Int32, lambda msg, tag: print(tag, msg.data), 'got')
        rospy.spin()
        """
    )
    sim.run(0.1)
    publisher = sim.graph.create_node("/mouth").advertise("/numbers", _int32())
    for number in range(5):
        publisher.publish(_int32()(number))
    sim.run(0.1)
    assert node.output.split("\n")[:-1] == [f"got {i}" for i in range(5)]


def _int32():
    from simkit.msgs import message_class

    return message_class("std_msgs/Int32")


def test_a_callback_that_sleeps_does_not_stop_the_main_loop(sim, run_script):
    node = run_script(
        """
        import rospy
        from std_msgs.msg import Int32
        rospy.init_node('two_threads')
        def slow(msg):
            rospy.sleep(1.0)
            print('callback done', round(rospy.get_time() - start, 3))
        start = rospy.get_time()
        rospy.Subscriber('numbers', Int32, slow)
        for _ in range(4):
            rospy.sleep(0.5)
            print('main', round(rospy.get_time() - start, 3))
        """
    )
    sim.rostopic_pub("/numbers", "std_msgs/Int32", "1")
    sim.run(3)
    assert node.output.splitlines() == [
        "main 0.5",
        "callback done 1.0",
        "main 1.0",
        "main 1.5",
        "main 2.0",
    ]


def test_threads_locks_and_queues_run_on_virtual_time(run_script):
    node = run_script(
        """
        import queue, threading, time
        from concurrent.futures import ThreadPoolExecutor
        import rospy
        rospy.init_node('threads')
        q, seen, lock = queue.Queue(), [], threading.Lock()
        def producer():
            for i in range(3):
                time.sleep(0.5)
                with lock:
                    q.put(i)
        thread = threading.Thread(target=producer)
        thread.start()
        for _ in range(3):
            seen.append((q.get(timeout=5), round(rospy.get_time() % 100, 3)))
        thread.join()
        with ThreadPoolExecutor(2) as pool:
            squares = list(pool.map(lambda v: v * v, range(4)))
        print(seen, squares, thread.is_alive())
        """,
        seconds=5,
    )
    assert node.failure is None
    assert node.output == "[(0, 0.5), (1, 1.0), (2, 1.5)] [0, 1, 4, 9] False\n"


def test_a_second_node_of_one_name_ends_the_first(sim, run_script):
    text = """
        import rospy
        rospy.init_node('twin')
        rospy.on_shutdown(lambda: print('goodbye'))
        rospy.spin()
        """
    first = run_script(text, name="first.py", seconds=0.1)
    second = run_script(text, name="second.py", seconds=0.1)
    assert not first.alive
    assert first.output == "goodbye\n"
    assert first.failure is None
    assert second.alive
    assert any("new node registered with same name" in str(record) for record in sim.log)


def test_private_parameters_names_and_remappings_of_the_command_line(sim, run_script):
    node = run_script(
        """
        import rospy, sys
        from std_msgs.msg import String
        rospy.init_node('plain')
        pub = rospy.Publisher('out', String, queue_size=1, latch=True)
        pub.publish(' '.join([rospy.get_name(), rospy.get_param('~turtle', 'none'), *rospy.myargv()[1:]]))
        rospy.spin()
        """,
        "_turtle:=turtle2",
        "__name:=other",
        "out:=/elsewhere",
        "own",
        seconds=0.1,
    )
    assert node.name == "/other"
    assert sim.latest("/elsewhere").data == "/other turtle2 own"
    assert sim.params.get("/other/turtle") == "turtle2"


def test_anonymous_nodes_have_names_of_their_own(sim, run_script):
    text = "import rospy\nrospy.init_node('same', anonymous=True)\nrospy.spin()\n"
    nodes = [run_script(text, seconds=0.01) for _ in range(2)]
    assert len({node.name for node in nodes}) == 2
    assert all(node.alive for node in nodes)


def test_services_between_scripts_and_from_python(sim, run_script):
    run_script(
        """
        import rospy
        from std_srvs.srv import SetBool, SetBoolResponse
        rospy.init_node('server')
        def handle(request):
            rospy.sleep(0.5)
            return SetBoolResponse(success=not request.data, message='turned')
        rospy.Service('switch', SetBool, handle)
        rospy.spin()
        """,
        name="server.py",
    )
    client = run_script(
        """
        import rospy
        from std_srvs.srv import SetBool
        rospy.init_node('client')
        rospy.wait_for_service('switch')
        answer = rospy.ServiceProxy('switch', SetBool)(True)
        print(answer.success, answer.message, round(rospy.get_time() % 100, 3))
        """,
        name="client.py",
    )
    sim.run(2)
    assert client.output == "False turned 0.5\n"
    assert sim.call("switch", data=False).success is True


def test_an_error_is_shown_with_the_students_lines_only(run_script):
    node = run_script(
        """
        import rospy
        rospy.init_node('faulty')
        def divide(a):
            return 1 / a
        divide(0)
        """,
        seconds=0.1,
    )
    assert not node.alive
    assert node.exit_code == 1
    assert (node.failure.kind, node.failure.file, node.failure.line, node.failure.function) == (
        "exception",
        "play/scripts/script.py",
        4,
        "divide",
    )
    assert "ZeroDivisionError" in node.failure.text
    assert "simkit" not in node.output


def test_a_syntax_error_names_its_line(run_script):
    node = run_script("import rospy\nrospy.init_node('x'\nprint(1)\n", seconds=0.1)
    assert node.failure.file == "play/scripts/script.py"
    assert node.failure.line == 2
    assert "SyntaxError" in node.failure.text


def test_a_callback_that_raises_is_a_fault_and_the_node_goes_on(sim, run_script):
    node = run_script(
        """
        import rospy
        from std_msgs.msg import Int32
        rospy.init_node('ear')
        rospy.Subscriber('numbers', Int32, lambda msg: msg.nothing)
        rospy.spin()
        """,
        seconds=0.1,
    )
    sim.rostopic_pub("/numbers", "std_msgs/Int32", "1")
    sim.run(0.1)
    assert node.alive
    assert node.failure.line == 4
    assert "AttributeError" in node.failure.text
    assert any("bad callback" in record.text for record in sim.log)


def test_an_abrupt_end_is_told_from_a_normal_one(run_script):
    node = run_script("import os, rospy\nrospy.init_node('x')\nos._exit(0)\n", seconds=0.1)
    assert node.failure.kind == "exit"
    assert node.exit_code == 0
    normal = run_script("import rospy, sys\nrospy.init_node('x')\nsys.exit(3)\n", seconds=0.1)
    assert normal.failure is None
    assert normal.exit_code == 3


def test_a_node_that_kills_itself(run_script):
    node = run_script("import os, signal\nos.kill(os.getpid(), signal.SIGKILL)\n", seconds=0.1)
    assert node.failure.kind == "killed"
    assert "SIGKILL" in node.failure.text


@pytest.fixture
def quick():
    """A runtime with a short allowance."""
    runtime = NodeRuntime(allowance=1.5, limits=NodeLimits(output_bytes=100_000))
    yield runtime
    runtime.close()


@pytest.fixture
def quick_sim(package, quick):
    with Simulation(package_path=[package.folder], screen=None, runtime=quick) as simulation:
        yield simulation


def test_a_stuck_script_is_named_and_the_rest_goes_on(quick_sim, package):
    package(
        "stuck.py",
        "import rospy\nrospy.init_node('stuck')\n\ndef loop():\n    while True:\n        x = 1\n\nloop()\n",
    )
    package(
        "fine.py",
        "import rospy\nrospy.init_node('fine')\nrospy.sleep(1)\nprint('woke')\nrospy.spin()\n",
    )
    stuck = quick_sim.rosrun("play", "stuck.py")
    fine = quick_sim.rosrun("play", "fine.py")
    quick_sim.run(2)
    assert stuck.failure.kind == "stuck"
    assert stuck.failure.file == "play/scripts/stuck.py"
    assert stuck.failure.line in (5, 6)
    assert stuck.failure.function == "loop"
    assert fine.alive
    assert fine.output == "woke\n"


def test_a_script_that_stops_itself_or_swallows_interrupts_is_stuck(quick_sim, package):
    package("stop.py", "import os, signal\nos.kill(os.getpid(), signal.SIGSTOP)\n")
    package(
        "deaf.py",
        "while True:\n    try:\n        while True: pass\n    except BaseException: pass\n",
    )
    nodes = [quick_sim.rosrun("play", name) for name in ("stop.py", "deaf.py")]
    quick_sim.run(0.1)
    assert [node.failure.kind for node in nodes] == ["stuck", "stuck"]


def test_a_flood_of_output_is_stopped_and_cut(quick_sim, package):
    package("flood.py", "while True:\n    print('x' * 1000)\n")
    node = quick_sim.rosrun("play", "flood.py")
    quick_sim.run(0.1)
    assert node.failure.kind == "output"
    assert len(node.output) == 100_000


def test_what_a_node_may_not_write_is_refused_with_a_sentence(sim, run_script):
    node = run_script(
        """
        import rospy
        from geometry_msgs.msg import Twist
        rospy.init_node('greedy')
        rospy.set_param('~mine', 1)
        try:
            rospy.set_param('/theirs', 1)
        except rospy.ROSException as error:
            print(error)
        rospy.Publisher('/turtle1/cmd_vel', Twist, queue_size=1)
        """,
        seconds=0.1,
        permissions=Permissions(publish=("/tf",), services=(), parameters=()),
    )
    assert sim.params.has("/greedy/mine")
    assert not sim.params.has("/theirs")
    assert "/turtle1/cmd_vel" not in sim.topics()
    assert "/theirs" in node.refusals[0]
    assert "/turtle1/cmd_vel" in node.refusals[1]
    assert "ROSException" in node.failure.text


def test_nothing_of_the_graph_can_be_imported_outside_nodes():
    import simkit.ros1

    with pytest.raises(ImportError, match=r"sim\.rosrun"):
        import simkit.ros1.rospy
    assert simkit.ros1.__doc__


def test_two_nodes_that_answer_each_other_at_once_do_not_stop_the_clock(sim, run_script):
    text = """
        import rospy, sys
        from std_msgs.msg import Int32
        me, other = rospy.myargv()[1:3]
        rospy.init_node(me)
        pub = rospy.Publisher(other, Int32, queue_size=1)
        rospy.Subscriber(me, Int32, lambda msg: pub.publish(msg.data + 1))
        rospy.sleep(0.1)
        pub.publish(0)
        rospy.spin()
        """
    run_script(text, "ping", "pong", name="ping.py")
    run_script(text, "pong", "ping", name="pong.py")
    sim.run(0.105)
    assert sim.now.to_sec() == pytest.approx(START + 0.105)
    assert sim.latest("/ping").data > 100


RUN_ON = """
    import os, random, rospy
    import numpy
    from std_msgs.msg import String
    rospy.init_node('dice')
    pub = rospy.Publisher('/dice', String, queue_size=10)
    rospy.Timer(rospy.Duration(0.03), lambda event: pub.publish('timer %r' % rospy.get_time()))
    rate = rospy.Rate(30)
    while not rospy.is_shutdown():
        pub.publish('%r %r %r' % (random.random(), numpy.random.rand(), hash('abc')))
        rate.sleep()
    """


def _run_dice(package, seed, method=None):
    package("dice.py", RUN_ON)
    runtime = NodeRuntime(method=method)
    with Simulation(seed, package_path=[package.folder], screen=None, runtime=runtime) as sim:
        record = sim.record({"/dice": "std_msgs/String"})
        sim.rosrun("play", "dice.py")
        sim.run(2.0)
        data = record.raw("/dice")
    runtime.close()
    return data


def test_same_seed_same_bytes_other_seed_other_bytes(package):
    first = _run_dice(package, 1)
    assert len(first) > 100
    assert _run_dice(package, 1) == first
    assert _run_dice(package, 2) != first


def test_same_bytes_with_a_spawned_interpreter_and_under_load(package):
    first = _run_dice(package, 1)
    burners = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(4)]
    try:
        assert _run_dice(package, 1) == first
        assert _run_dice(package, 1, method="spawn") == first
    finally:
        for burner in burners:
            burner.kill()
            burner.wait()


DETACH = """
    import os, subprocess, sys, time
    subprocess.Popen([sys.executable, '-c', 'import time; time.sleep(600)', 'MARK'], start_new_session=True)
    if os.fork() == 0:
        os.setsid()
        if os.fork() == 0:
            subprocess.run([sys.executable, '-c', 'import time; time.sleep(600)', 'MARK'])
        os._exit(0)
    """


def _marked(mark):
    found = []
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            if (
                mark.encode() in (folder / "cmdline").read_bytes()
                and int(folder.name) != os.getpid()
            ):
                found.append(int(folder.name))
        except OSError:
            continue
    return found


@pytest.mark.skipif(not Path("/proc/self/cmdline").exists(), reason="finds processes by /proc")
def test_detached_processes_of_a_script_end_with_it(package, sim, run_script):
    mark = f"mark{os.getpid()}a"
    node = run_script(DETACH.replace("MARK", mark), seconds=0.5)
    assert node.exit_code == 0
    assert _wait_for_none(mark) == []


def _wait_for_none(mark):
    for _ in range(100):
        if not _marked(mark):
            break
        time.sleep(0.05)
    return _marked(mark)


@pytest.mark.skipif(not Path("/proc/self/cmdline").exists(), reason="finds processes by /proc")
def test_no_process_is_left_when_the_simulation_is_killed(package, tmp_path):
    mark = f"mark{os.getpid()}b"
    package("stay.py", DETACH.replace("MARK", mark) + "\n    while True:\n        pass\n")
    package("wait.py", "import rospy\nrospy.init_node('wait')\nprint('up')\nrospy.spin()\n")
    parent = subprocess.Popen(
        [
            sys.executable,
            "-c",
            "import sys; from simkit import Simulation; "
            f"sim = Simulation(package_path=[{str(package.folder)!r}]); "
            "sim.rosrun('play', 'wait.py'); sim.run(1); print('ready', flush=True); "
            "sim.rosrun('play', 'stay.py'); sim.run(100)",
            mark,
        ],
        stdout=subprocess.PIPE,
        text=True,
    )
    assert parent.stdout.readline() == "up\n"
    assert parent.stdout.readline() == "ready\n"
    time.sleep(1.0)
    before = _children_of(parent.pid)
    assert before
    parent.kill()
    parent.wait()
    parent.stdout.close()
    assert _wait_for_none(mark) == []
    assert [pid for pid in before if _lives(pid)] == []


def _lives(pid):
    """Whether a process runs; one that only waits to be reaped does not."""
    for _ in range(100):
        try:
            state = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0]
        except OSError:
            return False
        if state == "Z":
            return False
        time.sleep(0.05)
    return True


def _children_of(pid):
    return [int(child) for child in Path(f"/proc/{pid}/task/{pid}/children").read_text().split()]


def test_a_publisher_made_in_every_callback_is_one_publisher(sim, run_script):
    node = run_script(
        """
        import rospy
        from std_msgs.msg import Header
        rospy.init_node('many')
        rate = rospy.Rate(100)
        while not rospy.is_shutdown():
            rospy.Publisher('/head', Header, queue_size=1).publish(Header())
            rate.sleep()
        """
    )
    record = sim.record({"/head": "std_msgs/Header"})
    sim.run(20)
    assert node.failure is None
    assert len(node.publishers) == 1
    assert len(record["/head"]) == 2000


def test_a_simulation_that_is_dropped_ends_its_nodes_when_the_next_begins(package):
    package("stay.py", "import rospy\nrospy.init_node('stay')\nrospy.spin()\n")
    first = Simulation(package_path=[package.folder], screen=None)
    node = first.rosrun("play", "stay.py")
    first.run(0.1)
    assert "running" in repr(node)
    del first
    with Simulation(package_path=[package.folder], screen=None):
        assert not node.alive
    assert "ended" in repr(node)
