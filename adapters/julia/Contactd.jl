"""
Elastic contact from Julia, over `contactd.h`: contacts and wheels on rails, solved in this process by `libcontactd-local`, or
by a daemon. Fields are named by their paths, as on the wire; units are N and mm, angles in rad.

    using .Contactd

    open_connection("local") do connection
        wheel = Wheel(connection)
        wheel["setup.model"] = "fastsim"
        wheel["state.position.y"] = 3.0
        wheel["state.velocity.x"] = 20e3
        wheel["state.velocity.pitch"] = -20e3 / 460
        wheel["state.Fz"] = 80e3
        solve!(wheel)
        forces = numbers(wheel, "forces.track")   # Fx, Fy, Fz, Mx, My, Mz on the rail
        close(wheel)
    end

The library is looked for by the system; the environment's `CONTACTD_LIBRARY` names it by its path.
"""
module Contactd

export Connection, Contact, CreepTable, Wheel, ContactdError, creep_forces, open_connection, start!, step!, again!, solve!, numbers, request!, clear!, save!, restore!

const LIBRARY = get(ENV, "CONTACTD_LIBRARY", "libcontactd-local")

"A call that failed: the code of the daemon's answers, a sentence, and the field that it is about, or \"\"."
struct ContactdError <: Exception
    code::Int32
    text::String
    field::String
end
Base.showerror(io::IO, error::ContactdError) = print(io, error.text)

"Where contacts are solved."
mutable struct Connection
    handle::Ptr{Cvoid}
end

"One contact, step by step. Fields are set and read by their paths: `contact[\"Fn\"] = 5e4`, `contact[\"forces.Fx\"]`."
mutable struct Contact
    handle::Ptr{Cvoid}
end

"One wheel on its rail: a right one, S1002 on 60E1 at 1/40, of steel, unless its fields say otherwise."
mutable struct Wheel
    handle::Ptr{Cvoid}
end

"Creep forces of steady rolling at one Poisson's ratio, from a file (docs/creep-tables.md). Any thread may use it."
mutable struct CreepTable
    handle::Ptr{Cvoid}
end

const Handle = Union{Contact, Wheel}

last_error(handle) = unsafe_string(ccall((:contactd_last_error, LIBRARY), Cstring, (Ptr{Cvoid},), handle))
last_field(handle) = unsafe_string(ccall((:contactd_last_field, LIBRARY), Cstring, (Ptr{Cvoid},), handle))

check(code, handle) = code == 0 ? nothing : throw(ContactdError(code, last_error(handle), last_field(handle)))

version() = unsafe_string(ccall((:contactd_version, LIBRARY), Cstring, ()))

"`\"local\"`, or the endpoint of a daemon, `\"ipc:///path\"`, `\"tcp://host:port\"`."
function Connection(endpoint::AbstractString)
    handle = Ref{Ptr{Cvoid}}(C_NULL)
    check(ccall((:contactd_open, LIBRARY), Int32, (Cstring, Ref{Ptr{Cvoid}}), endpoint, handle), C_NULL)
    return Connection(handle[])
end
Base.close(connection::Connection) = check(ccall((:contactd_close, LIBRARY), Int32, (Ptr{Cvoid},), connection.handle), C_NULL)

function open_connection(work::Function, endpoint::AbstractString)
    connection = Connection(endpoint)
    try
        return work(connection)
    finally
        close(connection)
    end
end

function Contact(connection::Connection)
    handle = Ref{Ptr{Cvoid}}(C_NULL)
    check(ccall((:contactd_new, LIBRARY), Int32, (Ptr{Cvoid}, Ref{Ptr{Cvoid}}), connection.handle, handle), connection.handle)
    return Contact(handle[])
end
function Wheel(connection::Connection)
    handle = Ref{Ptr{Cvoid}}(C_NULL)
    check(ccall((:contactd_wheel_new, LIBRARY), Int32, (Ptr{Cvoid}, Ref{Ptr{Cvoid}}), connection.handle, handle), connection.handle)
    return Wheel(handle[])
end
Base.close(contact::Contact) = check(ccall((:contactd_free, LIBRARY), Int32, (Ptr{Cvoid},), contact.handle), C_NULL)
Base.close(wheel::Wheel) = check(ccall((:contactd_wheel_free, LIBRARY), Int32, (Ptr{Cvoid},), wheel.handle), C_NULL)

function CreepTable(path::AbstractString, nu::Real)
    handle = Ref{Ptr{Cvoid}}(C_NULL)
    check(ccall((:contactd_creep_table_open, LIBRARY), Int32, (Cstring, Cdouble, Ref{Ptr{Cvoid}}), path, nu, handle), C_NULL)
    return CreepTable(handle[])
end
Base.close(table::CreepTable) = check(ccall((:contactd_creep_table_close, LIBRARY), Int32, (Ptr{Cvoid},), table.handle), C_NULL)

"""
Returns Fx, Fy (N) and Mz (N mm) on the upper body, their derivatives by xi, eta and phi in rows, and bounds of the errors of
forces and moment, which are NaN if the table was not checked. Creepages are xi, eta, and phi (1/mm).
"""
function creep_forces(table::CreepTable, a::Real, b::Real, G::Real, mu::Real, Fn::Real, creepages::AbstractVector{<:Real})
    length(creepages) == 3 || throw(ArgumentError("creepages has $(length(creepages)) values; give xi, eta and phi."))
    given = convert(Vector{Float64}, creepages)
    forces, jacobian, bounds = zeros(3), zeros(9), zeros(2)
    code = ccall((:contactd_creep_table_forces, LIBRARY), Int32,
        (Ptr{Cvoid}, Cdouble, Cdouble, Cdouble, Cdouble, Cdouble, Ptr{Cdouble}, Ptr{Cdouble}, Ptr{Cdouble}, Ptr{Cdouble}),
        table.handle, a, b, G, mu, Fn, given, forces, jacobian, bounds)
    check(code, table.handle)
    return forces, permutedims(reshape(jacobian, 3, 3)), bounds
end

# Sets a number, a keyword, or the numbers of a field. Rows of an array over the grid run along x.
Base.setindex!(of::Handle, value::Real, path::AbstractString) =
    check(ccall((:contactd_set, LIBRARY), Int32, (Ptr{Cvoid}, Cstring, Cdouble), of.handle, path, value), of.handle)
Base.setindex!(of::Handle, value::AbstractString, path::AbstractString) =
    check(ccall((:contactd_set_word, LIBRARY), Int32, (Ptr{Cvoid}, Cstring, Cstring), of.handle, path, value), of.handle)
function Base.setindex!(of::Handle, values::AbstractArray{<:Real}, path::AbstractString)
    given = convert(Vector{Float64}, vec(values))
    code = ccall((:contactd_set_array, LIBRARY), Int32, (Ptr{Cvoid}, Cstring, Ptr{Cdouble}, Int32), of.handle, path, given, length(given))
    check(code, of.handle)
end

"A number of the last answer."
function Base.getindex(of::Handle, path::AbstractString)
    value = Ref{Cdouble}(0)
    check(ccall((:contactd_get, LIBRARY), Int32, (Ptr{Cvoid}, Cstring, Ref{Cdouble}), of.handle, path, value), of.handle)
    return value[]
end

"All numbers of an object, a list, or an array over the grid that `request!` asked for."
function numbers(of::Handle, path::AbstractString)
    count = Ref{Int32}(0)
    check(ccall((:contactd_length, LIBRARY), Int32, (Ptr{Cvoid}, Cstring, Ref{Int32}), of.handle, path, count), of.handle)
    values = Vector{Float64}(undef, count[])
    code = ccall((:contactd_get_array, LIBRARY), Int32, (Ptr{Cvoid}, Cstring, Ptr{Cdouble}, Int32), of.handle, path, values, count[])
    check(code, of.handle)
    return values
end

"Whether answers from now on bring along an array over the grid, such as \"pressure\"."
request!(of::Handle, array::AbstractString, requested::Bool = true) =
    check(ccall((:contactd_want, LIBRARY), Int32, (Ptr{Cvoid}, Cstring, Int32), of.handle, array, requested), of.handle)

"Leaves a field out again."
clear!(of::Handle, path::AbstractString) =
    check(ccall((:contactd_clear, LIBRARY), Int32, (Ptr{Cvoid}, Cstring), of.handle, path), of.handle)

start!(contact::Contact) = check(ccall((:contactd_start, LIBRARY), Int32, (Ptr{Cvoid},), contact.handle), contact.handle)
step!(contact::Contact) = check(ccall((:contactd_step, LIBRARY), Int32, (Ptr{Cvoid},), contact.handle), contact.handle)
solve!(wheel::Wheel) = check(ccall((:contactd_wheel_solve, LIBRARY), Int32, (Ptr{Cvoid},), wheel.handle), wheel.handle)

"Solves the last step anew, with what is set now."
again!(of::Handle) = check(ccall((:contactd_step_again, LIBRARY), Int32, (Ptr{Cvoid},), of.handle), of.handle)

"Wheels of a vehicle, on so many threads; 0: as many as there are processors."
function solve!(wheels::AbstractVector{Wheel}; threads::Integer = 0)
    handles = Ptr{Cvoid}[wheel.handle for wheel in wheels]
    code = ccall((:contactd_wheel_solve_many, LIBRARY), Int32, (Ptr{Ptr{Cvoid}}, Int32, Int32), handles, length(handles), threads)
    check(code, C_NULL)
end

"Both wheels of a wheelset that is free to roll, each under its load."
solve!(right::Wheel, left::Wheel) =
    check(ccall((:contactd_wheel_solve_wheelset, LIBRARY), Int32, (Ptr{Cvoid}, Ptr{Cvoid}), right.handle, left.handle), right.handle)

"The name of where it is, to go back to by `restore!`."
function save!(of::Handle)
    state = Ref{Int32}(0)
    check(ccall((:contactd_save, LIBRARY), Int32, (Ptr{Cvoid}, Ref{Int32}), of.handle, state), of.handle)
    return state[]
end
restore!(of::Handle, state::Integer) =
    check(ccall((:contactd_restore, LIBRARY), Int32, (Ptr{Cvoid}, Int32), of.handle, state), of.handle)

end
