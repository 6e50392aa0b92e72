#include "creep_tables.hpp"

#include <cmath>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "contactd/creep_table.hpp"
#include "contactd/creep_table_nodes.hpp"

namespace contactd::python {
namespace {

std::vector<double> doubles(PyObject* bytes) {
    const std::string text = text_of(bytes);
    std::vector<double> values(text.size() / sizeof(double));
    std::memcpy(values.data(), text.data(), values.size() * sizeof(double));
    return values;
}

Reference bytes_of(const std::vector<double>& values) {
    return bytes({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double)});
}

std::filesystem::path path_of(const char* utf8) {
    return {reinterpret_cast<const char8_t*>(utf8)};
}

/// Calls `act` and reports errors of contactd as the module's Error.
template <class Act>
PyObject* answered(PyObject* module, const Act& act) {
    PyObject* const error = PyObject_GetAttrString(module, "Error");
    if (error == nullptr) return nullptr;
    PyObject* const found = answer(error, act);
    Py_DECREF(error);
    return found;
}

/// Returns a/b, and the creepages at the nodes of one a/b and one angle.
PyObject* nodes(PyObject* module, PyObject* arguments) {
    return answered(module, [&] {
        CreepTablePlan plan;
        auto& [ratios, cells, nus] = plan;
        double nu = 0;
        int ratio = 0, angle = 0;
        if (PyArg_ParseTuple(arguments, "(dd)(iiii)dii:creep_table_nodes", &ratios[0], &ratios[1], &cells[0], &cells[1],
                             &cells[2], &cells[3], &nu, &ratio, &angle) == 0)
            throw ExceptionIsSet();
        const Reference creepages = bytes_of(creep_table_creepages(plan, nu, ratio, angle));
        return Reference(Py_BuildValue("dO", creep_table_ratio(plan, ratio), creepages.get())).release();
    });
}

PyObject* write(PyObject* module, PyObject* arguments) {
    return answered(module, [&] {
        CreepTablePlan plan;
        auto& [ratios, cells, nus] = plan;
        const char* path = nullptr;
        PyObject *nu = nullptr, *forces = nullptr, *description = nullptr;
        if (PyArg_ParseTuple(arguments, "s(dd)(iiii)SSS:write_creep_table", &path, &ratios[0], &ratios[1], &cells[0],
                             &cells[1], &cells[2], &cells[3], &nu, &forces, &description) == 0)
            throw ExceptionIsSet();
        nus = doubles(nu);
        const std::filesystem::path written = path_of(path);
        const std::vector<double> all = doubles(forces);
        const std::string text = text_of(description);
        {
            const Unlocked unlocked;
            write_creep_table(written, plan, all, text);
        }
        return none();
    });
}

/// Returns the Poisson's ratio and the description of a table, and its forces for rows of a/b and three creepages.
PyObject* read(PyObject* module, PyObject* arguments) {
    return answered(module, [&] {
        const char* path = nullptr;
        PyObject *given = nullptr, *rows = nullptr;
        if (PyArg_ParseTuple(arguments, "sOS:read_creep_table", &path, &given, &rows) == 0) throw ExceptionIsSet();
        std::optional<double> nu;
        if (given != Py_None) nu = PyFloat_AsDouble(given);
        if (PyErr_Occurred() != nullptr) throw ExceptionIsSet();
        const std::filesystem::path opened = path_of(path);
        const std::vector<double> states = doubles(rows);
        std::vector<double> forces;
        std::string description;
        {
            const Unlocked unlocked;
            const CreepTable table(opened, nu);
            description = table.description();
            nu = table.nu();
            for (std::size_t i = 0; i + 4 <= states.size(); i += 4) {
                const double a = std::sqrt(states[i]);
                const CreepForces found =
                    table.forces({a, 1 / a, 1, 1, 1}, {states[i + 1], states[i + 2], states[i + 3]});
                for (const double force : found.forces) forces.push_back(-force);
            }
        }
        return Reference(Py_BuildValue("dOO", *nu, bytes(description).get(), bytes_of(forces).get())).release();
    });
}

}  // namespace

PyMethodDef creep_table_methods[] = {
    {"creep_table_nodes", &nodes, METH_VARARGS,
     "creep_table_nodes(ratios, cells, nu, ratio, angle): a/b and the creepages at nodes, as bytes of doubles."},
    {"write_creep_table", &write, METH_VARARGS,
     "write_creep_table(path, ratios, cells, nu, forces, description): fits and writes a table."},
    {"read_creep_table", &read, METH_VARARGS,
     "read_creep_table(path, nu, states): nu, description, and forces of a table for rows of a/b and creepages."},
    {nullptr, nullptr, 0, nullptr}};

}  // namespace contactd::python
