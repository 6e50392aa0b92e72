"""Defines values of a wheel on its rail. Import them from contactd.wheel_rail."""
