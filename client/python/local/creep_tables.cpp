#include "creep_tables.hpp"

#include <array>
#include <cstring>
#include <filesystem>
#include <memory>
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

/// Calls `act` and reports errors of contactd as the module's Error, or as ValueError for an argument.
template <class Act>
PyObject* answered(PyObject* module, const Act& act) {
    PyObject* const error = PyObject_GetAttrString(module, "Error");
    if (error == nullptr) return nullptr;
    PyObject* const found = answer(error, [&]() -> PyObject* {
        try {
            return act();
        } catch (const InvalidArgument& problem) {
            PyErr_SetString(PyExc_ValueError, problem.what());
            throw ExceptionIsSet();
        }
    });
    Py_DECREF(error);
    return found;
}

/// Returns the plan of the first two arguments, and sets the others.
template <class... Given>
CreepTablePlan parsed(PyObject* arguments, const char* format, Given*... given) {
    CreepTablePlan plan;
    auto& [ratios, cells, nus] = plan;
    if (PyArg_ParseTuple(arguments, format, &ratios[0], &ratios[1], &cells[0], &cells[1], &cells[2], &cells[3],
                         given...) == 0)
        throw ExceptionIsSet();
    return plan;
}

PyObject* rows(PyObject* module, PyObject* arguments) {
    return answered(module, [&] {
        const std::vector<int> counts = creep_table_rows(parsed(arguments, "(dd)(iiii):creep_table_rows"));
        return bytes_of({counts.begin(), counts.end()}).release();
    });
}

PyObject* row(PyObject* module, PyObject* arguments) {
    return answered(module, [&] {
        double nu = 0;
        int number = 0;
        const CreepTablePlan plan = parsed(arguments, "(dd)(iiii)di:creep_table_row", &nu, &number);
        const auto [ratio, creepages] = creep_table_row(plan, nu, number);
        return Py_BuildValue("dN", ratio, bytes_of(creepages).release());
    });
}

PyObject* creepages(PyObject* module, PyObject* arguments) {
    return answered(module, [&] {
        double nu = 0;
        PyObject* points = nullptr;
        const CreepTablePlan plan = parsed(arguments, "(dd)(iiii)dS:creep_table_creepages", &nu, &points);
        return bytes_of(creep_table_creepages(plan, nu, doubles(points))).release();
    });
}

PyObject* write(PyObject* module, PyObject* arguments) {
    return answered(module, [&] {
        const char* path = nullptr;
        PyObject *nu = nullptr, *forces = nullptr, *description = nullptr;
        CreepTablePlan plan = parsed(arguments, "(dd)(iiii)sSSS:write_creep_table", &path, &nu, &forces, &description);
        plan.nu = doubles(nu);
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

PyObject* certify(PyObject* module, PyObject* arguments) {
    return answered(module, [&] {
        const char* path = nullptr;
        std::array<int, 4> cells{};
        PyObject *bounds = nullptr, *description = nullptr;
        if (PyArg_ParseTuple(arguments, "s(iiii)SS:certify_creep_table", &path, &cells[0], &cells[1], &cells[2],
                             &cells[3], &bounds, &description) == 0)
            throw ExceptionIsSet();
        const std::vector<double> all = doubles(bounds);
        certify_creep_table(path_of(path), cells, std::vector<float>(all.begin(), all.end()), text_of(description));
        return none();
    });
}

constexpr const char* capsule = "contactd_local.creep_table";

PyObject* open(PyObject* module, PyObject* arguments) {
    return answered(module, [&] {
        const char* path = nullptr;
        PyObject* given = nullptr;
        if (PyArg_ParseTuple(arguments, "sO:open_creep_table", &path, &given) == 0) throw ExceptionIsSet();
        std::optional<double> nu;
        if (given != Py_None) nu = PyFloat_AsDouble(given);
        if (PyErr_Occurred() != nullptr) throw ExceptionIsSet();
        const std::filesystem::path opened = path_of(path);
        std::unique_ptr<CreepTable> table;
        {
            const Unlocked unlocked;
            table = std::make_unique<CreepTable>(opened, nu);
        }
        const auto [low, high] = table->ratios();
        Reference description = bytes(table->description());
        nu = table->nu();
        Reference handle(PyCapsule_New(table.get(), capsule, [](PyObject* object) {
            delete static_cast<CreepTable*>(PyCapsule_GetPointer(object, capsule));
        }));
        table.release();
        return Py_BuildValue("Nd(dd)N", handle.release(), *nu, low, high, description.release());
    });
}

/// Returns 29 numbers for each row of a, b, G, mu, Fn, xi, eta and phi, in the order of CreepForces.
PyObject* forces(PyObject* module, PyObject* arguments) {
    return answered(module, [&] {
        PyObject *handle = nullptr, *given = nullptr;
        if (PyArg_ParseTuple(arguments, "OS:creep_table_forces", &handle, &given) == 0) throw ExceptionIsSet();
        const auto* const table = static_cast<const CreepTable*>(PyCapsule_GetPointer(handle, capsule));
        if (table == nullptr) throw ExceptionIsSet();
        const std::vector<double> states = doubles(given);
        std::vector<double> results;
        {
            const Unlocked unlocked;
            results.reserve(states.size() / 8 * 29);
            for (std::size_t i = 0; i + 8 <= states.size(); i += 8) {
                const double* const at = states.data() + i;
                const CreepForces found = table->forces({at[0], at[1], at[2], at[3], at[4]}, {at[5], at[6], at[7]});
                const auto add = [&](const auto& values) {
                    results.insert(results.end(), values.begin(), values.end());
                };
                add(found.forces);
                for (const auto& of_force : found.by_creepage) add(of_force);
                for (const auto& of_force : found.by_contact) add(of_force);
                add(std::array{found.force_bound, found.moment_bound});
            }
        }
        return bytes_of(results).release();
    });
}

}  // namespace

PyMethodDef creep_table_methods[] = {
    {"creep_table_rows", &rows, METH_VARARGS,
     "creep_table_rows(ratios, cells): the number of nodes of each row at one nu."},
    {"creep_table_row", &row, METH_VARARGS,
     "creep_table_row(ratios, cells, nu, row): a/b and the creepages at nodes, as bytes of doubles."},
    {"creep_table_creepages", &creepages, METH_VARARGS,
     "creep_table_creepages(ratios, cells, nu, points): the creepages at points."},
    {"write_creep_table", &write, METH_VARARGS,
     "write_creep_table(ratios, cells, path, nu, forces, description): fits and writes a table."},
    {"certify_creep_table", &certify, METH_VARARGS,
     "certify_creep_table(path, cells, bounds, description): writes bounds and another description into a file."},
    {"open_creep_table", &open, METH_VARARGS,
     "open_creep_table(path, nu): a table, nu, the range of a/b, and the description."},
    {"creep_table_forces", &forces, METH_VARARGS,
     "creep_table_forces(table, states): 29 numbers for each a, b, G, mu, Fn, xi, eta and phi."},
    {nullptr, nullptr, 0, nullptr}};

}  // namespace contactd::python
