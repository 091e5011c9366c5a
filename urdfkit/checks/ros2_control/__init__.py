"""``<ros2_control>`` and the interfaces of its joints."""
