"""A lookup of tf2's own Python binding, for bench_tf: run by the system's python, prints microseconds.

The chain, the samples and the question are those of bench_tf; the argument is the number of links.
"""

import math
import statistics
import sys
import time

import rospy
import tf2_py
from geometry_msgs.msg import TransformStamped

STEP_NS = 16_000_000
SAMPLES = 200


def sample_of(link: int, sample: int) -> TransformStamped:
    """One sample of one link."""
    half = 0.005 * sample + 0.1 * link
    message = TransformStamped()
    message.header.stamp = rospy.Time(nsecs=(sample + 1) * STEP_NS)
    message.header.frame_id, message.child_frame_id = f"f{link}", f"f{link + 1}"
    place, turn = message.transform.translation, message.transform.rotation
    place.x, place.y, place.z = 1.0 + 0.01 * sample, 0.5, 0.1
    turn.z, turn.w = math.sin(half), math.cos(half)
    return message


def main() -> None:
    """Print the median time of the processor of one lookup [us]."""
    frames = int(sys.argv[1])
    buffer = tf2_py.BufferCore(rospy.Duration(10.0))
    for sample in range(SAMPLES):
        for link in range(frames):
            buffer.set_transform(sample_of(link, sample), "bench")
    when, rounds = rospy.Time(nsecs=100 * STEP_NS + STEP_NS // 3), []
    for _ in range(9):
        start = time.process_time()
        for _ in range(500):
            buffer.lookup_transform_core("f0", f"f{frames}", when)
        rounds.append((time.process_time() - start) / 500 * 1e6)
    print(statistics.median(rounds))


if __name__ == "__main__":
    main()
