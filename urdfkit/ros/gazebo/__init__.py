"""Gazebo: conversion of a robot to SDF, plugins, sensors, worlds."""

#: Texts by which `rejection` recognises messages of rules that also have milder findings.
REJECTED, REJECTED_BY_GZ = "Gazebo rejects the model", "gz-sim rejects the model"
