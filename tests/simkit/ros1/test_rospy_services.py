"""rospy: services and their clients."""

import pytest

SERVER = """
    from std_srvs.srv import SetBool, SetBoolResponse
    rospy.init_node('server')
    def handle(req):
        HANDLER
    rospy.Service('switch', SetBool, handle)
    rospy.spin()
    """
CLIENT = """
    from std_srvs.srv import SetBool, SetBoolRequest
    rospy.init_node('client')
    rospy.wait_for_service('switch', timeout=2)
    switch = rospy.ServiceProxy('switch', SetBool)
    try:
        answer = CALL
        print(answer.success, repr(answer.message))
    except rospy.ServiceException as error:
        print('ServiceException:', error)
    """
ERROR = "ServiceException: service [/switch] responded with an error: b"
HANDLERS = {
    "response": ("return SetBoolResponse(req.data, 'ok')", "True 'ok'"),
    "keywords": ("return SetBoolResponse(message='ok')", "False 'ok'"),
    "tuple": ("return req.data, 'ok'", "True 'ok'"),
    "list": ("return [req.data, 'ok']", "True 'ok'"),
    "dict": ("return {'success': True, 'message': 'ok'}", "True 'ok'"),
    "part of a dict": ("return {'message': 'ok'}", "False 'ok'"),
    "none": ("pass", f'{ERROR}"service cannot process request: service handler returned None"'),
    "too few": (
        "return [True]",
        f'{ERROR}"service cannot process request: handler returned wrong number of values: '
        "Invalid number of arguments",
    ),
    "one value": (
        "return True",
        f'{ERROR}"service cannot process request: handler returned invalid value: Invalid number of',
    ),
    "wrong key": (
        "return {'mesage': 'ok'}",
        f'{ERROR}"service cannot process request: handler returned invalid value: mesage is not',
    ),
    "refusal": (
        "raise rospy.ServiceException('no power')",
        f"{ERROR}'service cannot process request: no power'",
    ),
    "fault": ("return 1 / 0", f"{ERROR}'error processing request: division by zero'"),
    "wrong type": ("return True, 5", f"{ERROR}'error processing request: field message must be"),
}


def _quotes_aside(text):
    return text.replace('"', "'")


@pytest.mark.parametrize(("handler", "shown"), HANDLERS.values(), ids=HANDLERS)
def test_what_a_handler_may_return(prints, partner, handler, shown):
    partner(SERVER.replace("HANDLER", handler))
    output = prints(CLIENT.replace("CALL", "switch(True)"))
    assert _quotes_aside(output).startswith(_quotes_aside(shown))


def test_a_handler_that_raises_is_a_fault_of_the_server_that_goes_on(prints, partner, sim):
    server = partner(SERVER.replace("HANDLER", "return bool(1 / (0 if req.data else 1)), 'ok'"))
    prints(CLIENT.replace("CALL", "switch(True)"))
    assert server.alive
    assert (server.failure.kind, server.failure.line, server.failure.function) == (
        "exception",
        6,
        "handle",
    )
    assert any("Error processing request: division by zero" in r.text for r in sim.log)
    assert prints(CLIENT.replace("CALL", "switch(False)"), "__name:=again") == "True 'ok'\n"


def test_a_handler_that_refuses_is_no_fault(prints, partner, sim):
    server = partner(SERVER.replace("HANDLER", "raise rospy.ServiceException('no power')"))
    prints(CLIENT.replace("CALL", "switch(True)"))
    assert server.failure is None
    assert not any("Error processing" in record.text for record in sim.log)


def test_an_error_handler_takes_the_error(prints, partner):
    server = partner(
        """
        from std_srvs.srv import Empty
        rospy.init_node('server')
        def broken(req):
            raise RuntimeError('broken')
        def on_error(error, kind, value, trace):
            print('handled', error, kind.__name__)
        rospy.Service('go', Empty, broken, error_handler=on_error)
        rospy.spin()
        """
    )
    prints(
        """
        from std_srvs.srv import Empty
        rospy.init_node('client')
        try:
            rospy.ServiceProxy('go', Empty)()
        except rospy.ServiceException as error:
            print(error)
        """,
        seconds=1,
    )
    assert server.output == "handled broken RuntimeError\n"
    assert server.failure is None


CALLS = {
    "positional": "switch(True)",
    "keyword": "switch(data=True)",
    "request": "switch(SetBoolRequest(True))",
    "call": "switch.call(True)",
    "filled": "(lambda r: (setattr(r, 'data', True), switch(r))[1])(SetBoolRequest())",
}


@pytest.mark.parametrize("call", CALLS.values(), ids=CALLS)
def test_forms_of_calling(prints, partner, call):
    partner(SERVER.replace("HANDLER", "return req.data, type(req).__name__"))
    assert prints(CLIENT.replace("CALL", call)) == "True 'SetBoolRequest'\n"


CALL_ERRORS = {
    "too many": ("switch(True, 1)", "TypeError: Invalid number of arguments"),
    "unknown keyword": (
        "switch(dta=True)",
        "AttributeError: dta is not an attribute of SetBoolRequest",
    ),
    "wrong type": ("switch('yes')", "SerializationError: field data"),
    "another request": (
        "__import__('turtlesim.srv'); from turtlesim.srv import KillRequest; switch(KillRequest('x'))",
        "TypeError: expected [std_srvs/SetBoolRequest] but got [turtlesim/KillRequest]",
    ),
    "nobody": (
        "rospy.ServiceProxy('swich', SetBool)(True)",
        "ServiceException: service [/swich] unavailable",
    ),
    "another class": (
        "from std_srvs.srv import Empty; rospy.ServiceProxy('switch', Empty)()",
        "ServiceException: unable to connect to service: md5sums do not match: /switch is a std_srvs/SetBool",
    ),
    "waiting in vain": (
        "rospy.wait_for_service('nothing', timeout=1.5)",
        "ROSException: timeout exceeded while waiting for service /nothing",
    ),
    "no time at all": (
        "rospy.wait_for_service('switch', 0)",
        "ValueError: timeout must be non-zero",
    ),
}


@pytest.mark.parametrize(("call", "error"), CALL_ERRORS.values(), ids=CALL_ERRORS)
def test_what_cannot_be_called(run_script, partner, call, error):
    partner(SERVER.replace("HANDLER", "return req.data, 'ok'"))
    node = run_script(
        "import rospy\nfrom std_srvs.srv import SetBool\nrospy.init_node('x')\nrospy.sleep(0.5)\n"
        f"switch = rospy.ServiceProxy('switch', SetBool)\n{call}\n",
        seconds=4,
    )
    assert error in node.failure.text
    assert node.failure.line == 6


def test_waiting_takes_the_time_that_it_takes(prints, partner):
    partner(
        SERVER.replace("HANDLER", "return True, ''").replace("def", "rospy.sleep(2)\n    def", 1)
    )
    text = """
        rospy.init_node('x')
        start = rospy.get_time()
        rospy.wait_for_service('/switch')
        print(2.0 <= rospy.get_time() - start <= 2.31)
        """
    assert prints(text) == "True\n"


def test_a_server_that_dies_while_it_is_asked_is_an_error_of_the_call(prints, partner):
    partner(SERVER.replace("HANDLER", "rospy.sleep(1); import os; os._exit(1)"))
    output = prints(CLIENT.replace("CALL", "switch(True)"))
    assert output.startswith("ServiceException: transport error completing service call")


def test_a_shutdown_ends_a_call(sim, partner):
    partner(SERVER.replace("HANDLER", "rospy.sleep(1000)"))
    client = partner(CLIENT.replace("CALL", "switch(True)"), name="client.py")
    sim.run(1)
    client.shutdown()
    sim.run(1)
    assert not client.alive
    assert (client.failure, client.exit_code, client.output) == (None, 0, "")


def test_calls_wait_in_line_and_the_main_loop_goes_on(prints, partner, sim):
    server = partner(
        """
        from std_srvs.srv import SetBool
        rospy.init_node('server')
        def handle(req):
            rospy.sleep(1)
            print('served', round(rospy.get_time() % 100, 2))
            return True, ''
        rospy.Service('switch', SetBool, handle)
        while not rospy.is_shutdown():
            rospy.sleep(0.5)
        """
    )
    for name in ("a", "b"):
        partner(CLIENT.replace("CALL", "switch(True)"), f"__name:={name}", name=f"{name}.py")
    sim.run(5)
    first, second = (float(line.split()[1]) for line in server.output.splitlines())
    assert second == pytest.approx(first + 1)


def test_a_service_may_call_back_into_another_node(prints, partner):
    partner(
        """
        from std_srvs.srv import Trigger
        rospy.init_node('inner')
        rospy.Service('inner', Trigger, lambda req: (True, 'from inside'))
        rospy.spin()
        """
    )
    partner(
        """
        from std_srvs.srv import Trigger
        rospy.init_node('outer')
        inner = rospy.ServiceProxy('inner', Trigger)
        rospy.Service('outer', Trigger, lambda req: inner())
        rospy.spin()
        """,
        name="outer.py",
    )
    text = """
        from std_srvs.srv import Trigger
        rospy.init_node('x')
        outer = rospy.ServiceProxy('outer', Trigger)
        outer.wait_for_service()
        print(outer().message, outer.resolved_name)
        outer.close()
        """
    assert prints(text) == "from inside /outer\n"


def test_a_service_that_was_shut_down_is_gone(prints):
    text = """
        from std_srvs.srv import Empty
        rospy.init_node('x')
        service = rospy.Service('~go', Empty, lambda req: [])
        print(service.resolved_name, rospy.ServiceProxy('~go', Empty)())
        service.shutdown('enough')
        try:
            rospy.ServiceProxy('~go', Empty)()
        except rospy.ServiceException as error:
            print(error)
        """
    assert prints(text) == "/x/go \nservice [/x/go] unavailable\n"
