"""rospy: parameters."""

import pytest

READING = {
    "a value": ("rospy.get_param('/robot/speed')", "1.5"),
    "relative": ("rospy.get_param('robot/speed')", "1.5"),
    "private": ("rospy.get_param('~gain')", "3"),
    "a namespace": ("rospy.get_param('/robot')", "{'names': ['a', 'b'], 'speed': 1.5}"),
    "default": ("rospy.get_param('~missing', 7)", "7"),
    "default keyword": ("rospy.get_param('~missing', default='turtle1')", "turtle1"),
    "default none": ("rospy.get_param('/missing', None)", "None"),
    "set wins over default": ("rospy.get_param('/robot/speed', 9)", "1.5"),
    "cached": ("rospy.get_param_cached('/robot/speed')", "1.5"),
    "has": ("rospy.has_param('/robot'), rospy.has_param('/robot/sped')", "True False"),
    "names": (
        "[name for name in rospy.get_param_names() if not name.startswith('/x')]",
        "['/robot/names', '/robot/speed', '/speed']",
    ),
    "search finds the private one first": ("rospy.search_param('gain')", "/x/gain"),
    "search goes outwards": ("rospy.search_param('speed')", "/speed"),
    "search in vain": ("rospy.search_param('nothing')", "None"),
    "search global": (
        "rospy.search_param('/robot/speed'), rospy.search_param('/no')",
        "/robot/speed None",
    ),
}


@pytest.mark.parametrize(("expression", "shown"), READING.values(), ids=READING)
def test_reading(prints, sim, expression, shown):
    sim.params.set("/robot", {"speed": 1.5, "names": ["a", "b"]})
    sim.params.set("/speed", 2)
    output = prints(f"rospy.init_node('x')\nprint({expression})", "_gain:=3")
    if shown.startswith("{"):
        assert eval(output) == eval(shown)
    else:
        assert output.strip() == shown


def test_missing_parameters_are_key_errors_with_the_name_as_written(prints):
    text = """
        rospy.init_node('x')
        for function in (rospy.get_param, rospy.get_param_cached, rospy.delete_param):
            try:
                function('~speed')
            except KeyError as error:
                print(type(error).__name__, error)
        """
    assert prints(text) == "KeyError '~speed'\n" * 3


VALUES = [
    "1",
    "-2.5",
    "True",
    "'text äöü'",
    "[1, 'two', [3.0]]",
    "{'a': {'b': 1}, 'c': []}",
    "''",
    "0",
    "False",
]


@pytest.mark.parametrize("value", VALUES)
def test_values_come_back_as_they_went(prints, sim, value):
    text = f"""
        rospy.init_node('x')
        rospy.set_param('~value', {value})
        print(repr(rospy.get_param('~value')))
        print(rospy.has_param('~value'))
        """
    shown, there = prints(text).splitlines()
    assert eval(shown) == eval(value)
    assert there == "True"
    assert sim.params.get("/x/value") == eval(value)


def test_tuples_become_lists_and_numpy_floats_numbers(prints):
    text = """
        import numpy
        rospy.init_node('x')
        rospy.set_param('~value', (1, numpy.float64(2.5)))
        print(rospy.get_param('~value'))
        """
    assert prints(text) == "[1, 2.5]\n"


BAD_VALUES = {
    "none": ("None", "TypeError: cannot marshal None"),
    "none inside": ("{'a': [None]}", "TypeError: cannot marshal None"),
    "object": ("object()", "TypeError: cannot marshal <class 'object'> objects"),
    "array": (
        "__import__('numpy').zeros(3)",
        "TypeError: cannot marshal <class 'numpy.ndarray'> objects",
    ),
    "set": ("{1, 2}", "TypeError: cannot marshal <class 'set'> objects"),
    "keys": ("{1: 2}", "TypeError: dictionary key must be string"),
    "large": ("2**31", "OverflowError: int exceeds XML-RPC limits"),
    "message": ("rospy.Time(1)", "TypeError: cannot marshal"),
    "endless": ("(lambda l: (l.append(l), l)[1])([])", "TypeError: a parameter cannot be nested"),
}


@pytest.mark.parametrize(("value", "error"), BAD_VALUES.values(), ids=BAD_VALUES)
def test_what_no_parameter_can_hold(run_script, value, error):
    node = run_script(
        f"import rospy\nrospy.init_node('x')\nrospy.set_param('/a', {value})\n", seconds=0.1
    )
    assert error in node.failure.text
    assert node.failure.line == 3


def test_setting_a_dict_replaces_the_namespace_and_deleting_removes_it(prints):
    text = """
        rospy.init_node('x')
        rospy.set_param('/arm', {'p': 1, 'i': 2})
        rospy.set_param('/arm', {'d': 3})
        rospy.set_param('/arm/q', 4)
        print(rospy.get_param('/arm'))
        rospy.delete_param('/arm/q')
        print(rospy.get_param('/arm'))
        rospy.delete_param('/arm')
        print(rospy.has_param('/arm'))
        """
    assert prints(text) == "{'d': 3, 'q': 4}\n{'d': 3}\nFalse\n"


COMMAND_LINE = {
    "_n:=5": "5",
    "_n:=2.5": "2.5",
    "_n:=true": "True",
    "_n:=turtle2": "'turtle2'",
    "_n:=[1, 2]": "[1, 2]",
    "_n:={a: 1}": "{'a': 1}",
    "_n:='5'": "'5'",
    "_n:=": "''",
    "_n:=a:b": "'a:b'",
}


@pytest.mark.parametrize(("argument", "shown"), COMMAND_LINE.items(), ids=COMMAND_LINE)
def test_private_parameters_of_the_command_line_are_yaml(prints, argument, shown):
    assert (
        prints("rospy.init_node('x')\nprint(repr(rospy.get_param('~n')))", argument) == shown + "\n"
    )


def test_nodes_share_the_parameters(prints, partner):
    partner(
        "rospy.init_node('a')\nrospy.set_param('/shared', 'from a')\nrospy.set_param('~own', 1)"
    )
    text = """
        rospy.init_node('b')
        rospy.sleep(0.1)
        print(rospy.get_param('/shared'), rospy.get_param('/a/own'))
        """
    assert prints(text) == "from a 1\n"
