"""Names of packages that come with ROS, which a robot may use even if ROS is not installed."""

#: Packages of the desktop and simulation installations of ROS 1 and 2, and of common stacks.
#: Sources: the metapackages of REP 131, 142, 150 and 2001, and the repositories ros_control,
#: ros2_control, navigation, nav2, MoveIt, gazebo_ros_pkgs and ros_gz. Drivers are left out: their
#: nodes publish topics and frames that are not known.
_NAMES = frozenset(
    """
    ackermann_steering_controller actionlib admittance_controller amcl ament_index_python angles
    base_local_planner battery_state_broadcaster bicycle_steering_controller bondpy
    camera_info_manager carrot_planner class_loader clear_costmap_recovery cmake_modules
    compressed_image_transport control_msgs control_toolbox controller_interface controller_manager
    controller_manager_msgs costmap_2d cv_bridge demo_nodes_cpp demo_nodes_py depth_image_proc
    depthimage_to_laserscan diagnostic_aggregator diagnostic_msgs diagnostic_updater
    diff_drive_controller dwa_local_planner dwb_core dynamic_reconfigure effort_controllers
    eigen_conversions ekf_localization fake_localization filters force_torque_sensor_broadcaster
    force_torque_sensor_controller forward_command_controller gazebo_dev gazebo_msgs gazebo_plugins
    gazebo_ros gazebo_ros2_control gazebo_ros_control gencpp geometry_msgs global_planner gmapping
    gpio_controllers gps_sensor_broadcaster gripper_action_controller gripper_controllers
    gz_ros2_control gz_sim_vendor hardware_interface hector_mapping ign_ros2_control image_geometry
    image_pipeline image_proc image_publisher image_rotate image_transport image_view
    imu_complementary_filter imu_filter_madgwick imu_sensor_broadcaster imu_sensor_controller
    interactive_marker_twist_server interactive_markers joint_limits joint_limits_interface
    joint_state_broadcaster joint_state_controller joint_state_publisher joint_state_publisher_gui
    joint_trajectory_controller joy joy_linux joy_teleop kdl_parser kinematics_interface
    kinematics_interface_kdl laser_assembler laser_filters laser_geometry laser_pipeline launch
    launch_ros launch_testing launch_xml launch_yaml magnetometer_broadcaster map_server
    master_discovery_fkie mavros mecanum_drive_controller message_filters
    motion_primitives_controllers move_base move_slow_and_clear moveit moveit_commander
    moveit_configs_utils moveit_controller_manager moveit_fake_controller_manager moveit_kinematics
    moveit_planners moveit_planners_chomp moveit_planners_ompl moveit_planners_stomp
    moveit_ros_benchmarks moveit_ros_control_interface moveit_ros_move_group
    moveit_ros_occupancy_map_monitor moveit_ros_perception moveit_ros_planning
    moveit_ros_planning_interface moveit_ros_visualization moveit_ros_warehouse moveit_servo
    moveit_setup_assistant moveit_simple_controller_manager multimaster_launch nav2_amcl
    nav2_behaviors nav2_bringup nav2_bt_navigator nav2_collision_monitor nav2_common nav2_controller
    nav2_costmap_2d nav2_graceful_controller nav2_lifecycle_manager nav2_map_server
    nav2_mppi_controller nav2_msgs nav2_navfn_planner nav2_planner
    nav2_regulated_pure_pursuit_controller nav2_rotation_shim_controller nav2_rviz_plugins
    nav2_simple_commander nav2_smac_planner nav2_smoother nav2_velocity_smoother
    nav2_waypoint_follower nav_core nav_msgs navfn navigation nodelet nodelet_topic_tools
    octomap_server omni_wheel_drive_controller pal_statistics parallel_gripper_controller
    pcl_conversions pcl_ros pick_ik pid_controller pilz_industrial_motion_planner pluginlib
    pointcloud_to_laserscan pointgrey_camera_driver pose_broadcaster position_controllers
    python_orocos_kdl range_sensor_broadcaster rclcpp rclcpp_components rclpy realsense2_camera
    resource_retriever robot_localization robot_pose_ekf robot_state_publisher ros1_bridge
    ros2_control ros2_controllers ros2action ros2bag ros2cli ros2component ros2control ros2launch
    ros2lifecycle ros2node ros2param ros2pkg ros2run ros2service ros2topic ros_control
    ros_controllers ros_gz ros_gz_bridge ros_gz_image ros_gz_interfaces ros_gz_sim ros_ign_bridge
    ros_ign_gazebo rosapi rosbag rosbridge_server roscpp roscpp_tutorials roslaunch roslib rosmaster
    rosnode rosout rosparam rospy rospy_tutorials rosserial_python rosservice rostest rostopic
    rosunit rotate_recovery rqt rqt_action rqt_bag rqt_common_plugins rqt_console
    rqt_controller_manager rqt_dep rqt_graph rqt_gui rqt_gui_py rqt_image_view
    rqt_joint_trajectory_controller rqt_plot rqt_reconfigure rqt_robot_steering rqt_tf_tree
    rqt_topic rtabmap_launch rtabmap_odom rtabmap_ros rtabmap_slam rviz rviz2 rviz_common
    rviz_default_plugins rviz_imu_plugin rviz_visual_tools sensor_msgs shape_msgs slam_gmapping
    slam_toolbox smach spacenav_node srdfdom static_transform_publisher std_msgs std_srvs
    steering_controllers_library stereo_image_proc stereo_msgs teleop_twist_joy
    teleop_twist_keyboard tf tf2 tf2_bullet tf2_eigen tf2_geometry_msgs tf2_kdl tf2_msgs tf2_ros
    tf2_sensor_msgs tf2_tools tf_conversions theora_image_transport topic_based_ros2_control
    topic_tools trac_ik_kinematics_plugin trajectory_msgs transmission_interface tricycle_controller
    tricycle_steering_controller turtle_tf turtle_tf2 turtlesim twist_mux urdf urdf_launch
    urdf_parser_plugin urdfdom urg_node usb_cam velocity_controllers vision_opencv
    visualization_msgs voxel_grid warehouse_ros warehouse_ros_mongo web_video_server xacro
    yocs_velocity_smoother
    """.split()
)


def comes_with_ros(name: str) -> bool:
    """True for a package of ROS or of a common stack."""
    return name in _NAMES
