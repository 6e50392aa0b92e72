"""Loads functions that draw, convert and store values. Only this module imports both values and their libraries."""

from __future__ import annotations

__all__ = ["FUNCTIONS"]

#: Methods of values and their functions. Most need the library of an extra, and raise MissingExtra without it.
FUNCTIONS = {
    "CreepCurve.plot": "contactd.pictures.curves:draw_creep_curve",
    "Fit.plot": "contactd.pictures.fit:draw_fit",
    "IcTable.operator": "contactd.operators:linear_operator",
    "IcTable.plot": "contactd.pictures.tables:draw_table",
    "IcTable.to_xarray": "contactd.xarray_datasets:table_array",
    "ModelComparison.plot": "contactd.pictures.comparison:draw_comparison",
    "ProfileFile.text": "contactd.files.profile_text:read_profile_text",
    "PassageWear.plot": "contactd.pictures.wear:draw_passage",
    "Saved.load": "contactd.files.saved:load",
    "Saved.save": "contactd.files.saved:save",
    "ContactSolution.plot": "contactd.pictures.contact:draw_contact",
    "ContactSolution.plot_section": "contactd.pictures.contact:draw_section",
    "ContactSolution.to_xarray": "contactd.xarray_datasets:solution_dataset",
    "SubsurfaceStress.plot": "contactd.pictures.stresses:draw_stress",
    "SubsurfaceStress.to_xarray": "contactd.xarray_datasets:stress_dataset",
    "TableIcs.from_contact_text": "contactd.files.contact_text:read_text",
    "TableIcs.to_contact_text": "contactd.files.contact_text:format_text",
    "WheelRailSolution.plot": "contactd.pictures.wheel_rail:draw_wheel_rail",
    "WheelRailSolution.wear": "contactd.wear.passage:passage_wear",
}
