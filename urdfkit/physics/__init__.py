"""What needs Pinocchio or coal: dynamics, self-collision, poses."""
