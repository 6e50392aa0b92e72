! The functions of contactd.h as C has them. Use contactd.f90, which has the words, and texts as Fortran's, too.
module contactd_calls
    use, intrinsic :: iso_c_binding
    implicit none

    interface
        integer(c_int32_t) function contactd_version_number() bind(c)
            import
        end function
        integer(c_int32_t) function contactd_has_local() bind(c)
            import
        end function
        integer(c_int32_t) function contactd_last_code(handle) bind(c)
            import; type(c_ptr), value :: handle
        end function
        integer(c_int32_t) function contactd_close(connection) bind(c)
            import; type(c_ptr), value :: connection
        end function
        integer(c_int32_t) function contactd_ping(connection) bind(c)
            import; type(c_ptr), value :: connection
        end function
        integer(c_int32_t) function contactd_set_timeout(connection, seconds) bind(c)
            import; type(c_ptr), value :: connection; real(c_double), value :: seconds
        end function
        integer(c_int32_t) function contactd_set_build_timeout(connection, seconds) bind(c)
            import; type(c_ptr), value :: connection; real(c_double), value :: seconds
        end function
        integer(c_int32_t) function contactd_set_connect_timeout(connection, seconds) bind(c)
            import; type(c_ptr), value :: connection; real(c_double), value :: seconds
        end function
        integer(c_int32_t) function contactd_set_log(connection, log, user) bind(c)
            import; type(c_ptr), value :: connection; type(c_funptr), value :: log; type(c_ptr), value :: user
        end function
        integer(c_int32_t) function contactd_new(connection, contact) bind(c)
            import; type(c_ptr), value :: connection; type(c_ptr), intent(out) :: contact
        end function
        integer(c_int32_t) function contactd_free(contact) bind(c)
            import; type(c_ptr), value :: contact
        end function
        integer(c_int32_t) function contactd_start(contact) bind(c)
            import; type(c_ptr), value :: contact
        end function
        integer(c_int32_t) function contactd_step(contact) bind(c)
            import; type(c_ptr), value :: contact
        end function
        integer(c_int32_t) function contactd_cancel(contact) bind(c)
            import; type(c_ptr), value :: contact
        end function
        integer(c_int32_t) function contactd_save(contact, state) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), intent(out) :: state
        end function
        integer(c_int32_t) function contactd_restore(contact, state) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), value :: state
        end function
        integer(c_int32_t) function contactd_forget(contact, state) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), value :: state
        end function
        integer(c_int32_t) function contactd_set_grid(contact, nx, ny, dx, dy, x0, y0) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), value :: nx, ny
            real(c_double), value :: dx, dy, x0, y0
        end function
        integer(c_int32_t) function contactd_set_grid_centred(contact, nx, ny, dx, dy) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), value :: nx, ny
            real(c_double), value :: dx, dy
        end function
        integer(c_int32_t) function contactd_set_material(contact, body, G, nu) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), value :: body; real(c_double), value :: G, nu
        end function
        integer(c_int32_t) function contactd_set_rigid(contact, body) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), value :: body
        end function
        integer(c_int32_t) function contactd_set_half_space(contact, body, load_shape) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), value :: body, load_shape
        end function
        integer(c_int32_t) function contactd_set_fem(contact, body, shape, load_shape, accuracy, L_over_h) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), value :: body, shape, load_shape
            real(c_double), value :: accuracy, L_over_h
        end function
        integer(c_int32_t) function contactd_set_table(contact, body, nx, ny, dx, dy, values, count) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), value :: body, nx, ny
            real(c_double), value :: dx, dy; real(c_double), intent(in) :: values(*)
            integer(c_int32_t), value :: count
        end function
        integer(c_int32_t) function contactd_set_line_contact(contact, datum) bind(c)
            import; type(c_ptr), value :: contact; real(c_double), value :: datum
        end function
        integer(c_int32_t) function contactd_set_layers(contact, body, load_shape, thickness, G, nu, count, &
                                                        base_G, base_nu) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), value :: body, load_shape, count
            real(c_double), intent(in) :: thickness(*), G(*), nu(*); real(c_double), value :: base_G, base_nu
        end function
        integer(c_int32_t) function contactd_set_section(contact, body, shape, numbers, count) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), value :: body, shape, count
            real(c_double), intent(in) :: numbers(*)
        end function
        integer(c_int32_t) function contactd_set_profile_points(contact, body, kind, y, z, count, smoothing_length, &
                                                                depth, from) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), value :: body, kind, count
            real(c_double), intent(in) :: y(*), z(*); real(c_double), value :: smoothing_length, depth, from
        end function
        integer(c_int32_t) function set_profile_file_c(contact, body, kind, path, smoothing_length, depth, from) &
            bind(c, name="contactd_set_profile_file")
            import; type(c_ptr), value :: contact; integer(c_int32_t), value :: body, kind
            character(c_char), intent(in) :: path(*); real(c_double), value :: smoothing_length, depth, from
        end function
        integer(c_int32_t) function contactd_set_outline(contact, body, y, z) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), value :: body; real(c_double), value :: y, z
        end function
        integer(c_int32_t) function contactd_add_line(contact, body, y, z, clamped) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), value :: body, clamped
            real(c_double), value :: y, z
        end function
        integer(c_int32_t) function contactd_add_arc(contact, body, y, z, radius, clamped) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), value :: body, clamped
            real(c_double), value :: y, z, radius
        end function
        integer(c_int32_t) function contactd_add_spline(contact, body, y, z, count, clamped) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), value :: body, count, clamped
            real(c_double), intent(in) :: y(*), z(*)
        end function
        integer(c_int32_t) function contactd_add_hole(contact, body, y, z) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), value :: body; real(c_double), value :: y, z
        end function
        integer(c_int32_t) function contactd_set_first_column(contact, body, carrier, part, from) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), value :: body, carrier, part
            real(c_double), value :: from
        end function
        integer(c_int32_t) function contactd_set_section_place(contact, body, size, turn) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), value :: body
            real(c_double), value :: size, turn
        end function
        integer(c_int32_t) function contactd_set_section_accuracy(contact, body, accuracy) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), value :: body
            real(c_double), value :: accuracy
        end function
        integer(c_int32_t) function contactd_set_columns(contact, y, z, angle, count, direction, origin_y, origin_z) &
            bind(c)
            import; type(c_ptr), value :: contact; real(c_double), intent(in) :: y(*), z(*), angle(*)
            integer(c_int32_t), value :: count; real(c_double), value :: direction, origin_y, origin_z
        end function
        integer(c_int32_t) function contactd_get_frames(contact, body, y, z, angle, length) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), value :: body, length
            real(c_double), intent(out) :: y(*), z(*), angle(*)
        end function
        integer(c_int32_t) function contactd_get_resultant(contact, forces) bind(c)
            import; type(c_ptr), value :: contact; real(c_double), intent(out) :: forces(*)
        end function
        integer(c_int32_t) function contactd_set_model(contact, model) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), value :: model
        end function
        integer(c_int32_t) function contactd_set_tolerance(contact, solver, tolerance, max_iterations) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), value :: solver
            real(c_double), value :: tolerance; integer(c_int32_t), value :: max_iterations
        end function
        integer(c_int32_t) function contactd_set_accept_unconverged(contact, accept) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), value :: accept
        end function
        integer(c_int32_t) function contactd_set_previous(contact, pressure, traction_x, traction_y, count) bind(c)
            import; type(c_ptr), value :: contact
            real(c_double), intent(in) :: pressure(*), traction_x(*), traction_y(*)
            integer(c_int32_t), value :: count
        end function
        integer(c_int32_t) function contactd_set_lease(contact, seconds) bind(c)
            import; type(c_ptr), value :: contact; real(c_double), value :: seconds
        end function
        integer(c_int32_t) function contactd_set_approach(contact, approach) bind(c)
            import; type(c_ptr), value :: contact; real(c_double), value :: approach
        end function
        integer(c_int32_t) function contactd_set_Fn(contact, Fn) bind(c, name="contactd_set_Fn")
            import; type(c_ptr), value :: contact; real(c_double), value :: Fn
        end function
        integer(c_int32_t) function contactd_set_paraboloid(contact, Rx, Ry) bind(c)
            import; type(c_ptr), value :: contact; real(c_double), value :: Rx, Ry
        end function
        integer(c_int32_t) function contactd_set_semi_axes(contact, a, b) bind(c)
            import; type(c_ptr), value :: contact; real(c_double), value :: a, b
        end function
        integer(c_int32_t) function contactd_set_gap(contact, gap, count) bind(c)
            import; type(c_ptr), value :: contact; real(c_double), intent(in) :: gap(*)
            integer(c_int32_t), value :: count
        end function
        integer(c_int32_t) function contactd_set_mu(contact, mu) bind(c)
            import; type(c_ptr), value :: contact; real(c_double), value :: mu
        end function
        integer(c_int32_t) function contactd_set_mu_array(contact, mu, count) bind(c)
            import; type(c_ptr), value :: contact; real(c_double), intent(in) :: mu(*)
            integer(c_int32_t), value :: count
        end function
        integer(c_int32_t) function contactd_set_kinetic(contact, law, mu, slip_velocity) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), value :: law
            real(c_double), value :: mu, slip_velocity
        end function
        integer(c_int32_t) function contactd_set_shift(contact, x, y, rotation) bind(c)
            import; type(c_ptr), value :: contact; real(c_double), value :: x, y, rotation
        end function
        integer(c_int32_t) function contactd_set_duration(contact, duration) bind(c)
            import; type(c_ptr), value :: contact; real(c_double), value :: duration
        end function
        integer(c_int32_t) function contactd_set_rolling(contact, kind, xi, eta, phi) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), value :: kind
            real(c_double), value :: xi, eta, phi
        end function
        integer(c_int32_t) function contactd_set_direction(contact, chi, dq) bind(c)
            import; type(c_ptr), value :: contact; real(c_double), value :: chi, dq
        end function
        integer(c_int32_t) function contactd_set_spin_offset(contact, spin_offset) bind(c)
            import; type(c_ptr), value :: contact; real(c_double), value :: spin_offset
        end function
        integer(c_int32_t) function contactd_set_rolling_steps(contact, steps) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), value :: steps
        end function
        integer(c_int32_t) function contactd_set_velocity(contact, velocity) bind(c)
            import; type(c_ptr), value :: contact; real(c_double), value :: velocity
        end function
        integer(c_int32_t) function contactd_set_Fx(contact, Fx) bind(c, name="contactd_set_Fx")
            import; type(c_ptr), value :: contact; real(c_double), value :: Fx
        end function
        integer(c_int32_t) function contactd_set_Fy(contact, Fy) bind(c, name="contactd_set_Fy")
            import; type(c_ptr), value :: contact; real(c_double), value :: Fy
        end function
        integer(c_int32_t) function contactd_clear_forces(contact) bind(c)
            import; type(c_ptr), value :: contact
        end function
        integer(c_int32_t) function contactd_set_rigid_slip(contact, x, y, count) bind(c)
            import; type(c_ptr), value :: contact; real(c_double), intent(in) :: x(*), y(*)
            integer(c_int32_t), value :: count
        end function
        integer(c_int32_t) function contactd_step_again(contact) bind(c)
            import; type(c_ptr), value :: contact
        end function
        integer(c_int32_t) function contactd_want_derivatives(contact, wanted) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), value :: wanted
        end function
        integer(c_int32_t) function contactd_get_derivative(contact, of, by, value) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), value :: of, by; real(c_double), intent(out) :: value
        end function
        integer(c_int32_t) function contactd_set_step_timeout(contact, seconds) bind(c)
            import; type(c_ptr), value :: contact; real(c_double), value :: seconds
        end function
        integer(c_int32_t) function contactd_get_step(contact, step) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), intent(out) :: step
        end function
        integer(c_int32_t) function contactd_get_forces(contact, Fn, Fx, Fy, Mz) bind(c)
            import; type(c_ptr), value :: contact; real(c_double), intent(out) :: Fn, Fx, Fy, Mz
        end function
        integer(c_int32_t) function contactd_get_approach(contact, approach) bind(c)
            import; type(c_ptr), value :: contact; real(c_double), intent(out) :: approach
        end function
        integer(c_int32_t) function contactd_get_pmax(contact, pmax) bind(c)
            import; type(c_ptr), value :: contact; real(c_double), intent(out) :: pmax
        end function
        integer(c_int32_t) function contactd_get_areas(contact, in_contact, adhesion, slip) bind(c)
            import; type(c_ptr), value :: contact; real(c_double), intent(out) :: in_contact, adhesion, slip
        end function
        integer(c_int32_t) function contactd_get_counts(contact, in_contact, adhesion, slip, border) bind(c)
            import; type(c_ptr), value :: contact
            integer(c_int32_t), intent(out) :: in_contact, adhesion, slip, border
        end function
        integer(c_int32_t) function contactd_get_creepages(contact, xi, eta, phi) bind(c)
            import; type(c_ptr), value :: contact; real(c_double), intent(out) :: xi, eta, phi
        end function
        integer(c_int32_t) function contactd_get_shift(contact, x, y, rotation) bind(c)
            import; type(c_ptr), value :: contact; real(c_double), intent(out) :: x, y, rotation
        end function
        integer(c_int32_t) function contactd_get_frictional_work(contact, work) bind(c)
            import; type(c_ptr), value :: contact; real(c_double), intent(out) :: work
        end function
        integer(c_int32_t) function contactd_get_frictional_power(contact, power) bind(c)
            import; type(c_ptr), value :: contact; real(c_double), intent(out) :: power
        end function
        integer(c_int32_t) function contactd_get_converged(contact, converged) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), intent(out) :: converged
        end function
        integer(c_int32_t) function contactd_get_evidence(contact, solver, iterations, residual, converged) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), value :: solver
            integer(c_int32_t), intent(out) :: iterations; real(c_double), intent(out) :: residual
            integer(c_int32_t), intent(out) :: converged
        end function
        integer(c_int32_t) function contactd_get_discretisation(contact, elements_across, force_error, &
            pmax_error, rolling_error) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), intent(out) :: elements_across
            real(c_double), intent(out) :: force_error, pmax_error, rolling_error
        end function
        integer(c_int32_t) function contactd_get_warnings(contact, count) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), intent(out) :: count
        end function

        ! Those with texts, under other names: contactd.f90 has them with Fortran's.
        type(c_ptr) function version_c() bind(c, name="contactd_version")
            import
        end function
        type(c_ptr) function code_name_c(code) bind(c, name="contactd_code_name")
            import; integer(c_int32_t), value :: code
        end function
        type(c_ptr) function last_error_c(handle) bind(c, name="contactd_last_error")
            import; type(c_ptr), value :: handle
        end function
        type(c_ptr) function last_field_c(handle) bind(c, name="contactd_last_field")
            import; type(c_ptr), value :: handle
        end function
        type(c_ptr) function last_reason_c(handle) bind(c, name="contactd_last_reason")
            import; type(c_ptr), value :: handle
        end function
        integer(c_int32_t) function open_c(where, connection) bind(c, name="contactd_open")
            import; character(c_char), intent(in) :: where(*); type(c_ptr), intent(out) :: connection
        end function
        integer(c_int32_t) function set_keys_c(connection, server_key, own_key) bind(c, name="contactd_set_keys")
            import; type(c_ptr), value :: connection; character(c_char), intent(in) :: server_key(*), own_key(*)
        end function
        integer(c_int32_t) function get_warning_c(contact, index, text, length) bind(c, name="contactd_get_warning")
            import; type(c_ptr), value :: contact; integer(c_int32_t), value :: index, length
            character(c_char), intent(out) :: text(*)
        end function
        integer(c_int32_t) function get_origin_c(contact, body, text, length) bind(c, name="contactd_get_origin")
            import; type(c_ptr), value :: contact; integer(c_int32_t), value :: body, length
            character(c_char), intent(out) :: text(*)
        end function
        integer(c_int32_t) function set_c(handle, path, value) bind(c, name="contactd_set")
            import; type(c_ptr), value :: handle; character(c_char), intent(in) :: path(*); real(c_double), value :: value
        end function
        integer(c_int32_t) function set_word_c(handle, path, word) bind(c, name="contactd_set_word")
            import; type(c_ptr), value :: handle; character(c_char), intent(in) :: path(*), word(*)
        end function
        integer(c_int32_t) function clear_c(handle, path) bind(c, name="contactd_clear")
            import; type(c_ptr), value :: handle; character(c_char), intent(in) :: path(*)
        end function
        integer(c_int32_t) function get_c(handle, path, value) bind(c, name="contactd_get")
            import; type(c_ptr), value :: handle; character(c_char), intent(in) :: path(*)
            real(c_double), intent(out) :: value
        end function
        integer(c_int32_t) function get_word_c(handle, path, text, length) bind(c, name="contactd_get_word")
            import; type(c_ptr), value :: handle; character(c_char), intent(in) :: path(*)
            character(c_char), intent(out) :: text(*); integer(c_int32_t), value :: length
        end function
        integer(c_int32_t) function set_array_c(handle, path, values, count) bind(c, name="contactd_set_array")
            import; type(c_ptr), value :: handle; character(c_char), intent(in) :: path(*)
            real(c_double), intent(in) :: values(*); integer(c_int32_t), value :: count
        end function
        integer(c_int32_t) function get_array_c(handle, path, values, count) bind(c, name="contactd_get_array")
            import; type(c_ptr), value :: handle; character(c_char), intent(in) :: path(*)
            real(c_double), intent(out) :: values(*); integer(c_int32_t), value :: count
        end function
        integer(c_int32_t) function length_c(handle, path, count) bind(c, name="contactd_length")
            import; type(c_ptr), value :: handle; character(c_char), intent(in) :: path(*)
            integer(c_int32_t), intent(out) :: count
        end function
        integer(c_int32_t) function want_c(handle, array, wanted) bind(c, name="contactd_want")
            import; type(c_ptr), value :: handle; character(c_char), intent(in) :: array(*)
            integer(c_int32_t), value :: wanted
        end function
        integer(c_int32_t) function path_c(handle, path, id) bind(c, name="contactd_path")
            import; type(c_ptr), value :: handle; character(c_char), intent(in) :: path(*)
            integer(c_int32_t), intent(out) :: id
        end function
        integer(c_int32_t) function contactd_set_at(handle, id, value) bind(c)
            import; type(c_ptr), value :: handle; integer(c_int32_t), value :: id; real(c_double), value :: value
        end function
        integer(c_int32_t) function contactd_get_at(handle, id, value) bind(c)
            import; type(c_ptr), value :: handle; integer(c_int32_t), value :: id
            real(c_double), intent(out) :: value
        end function
        integer(c_int32_t) function contactd_wheel_new(connection, wheel) bind(c)
            import; type(c_ptr), value :: connection; type(c_ptr), intent(out) :: wheel
        end function
        integer(c_int32_t) function contactd_wheel_free(wheel) bind(c)
            import; type(c_ptr), value :: wheel
        end function
        integer(c_int32_t) function contactd_wheel_solve(wheel) bind(c)
            import; type(c_ptr), value :: wheel
        end function
        integer(c_int32_t) function contactd_wheel_solve_wheelset(right, left) bind(c)
            import; type(c_ptr), value :: right, left
        end function
        integer(c_int32_t) function contactd_wheel_cancel(wheel) bind(c)
            import; type(c_ptr), value :: wheel
        end function
        integer(c_int32_t) function contactd_wheel_set_timeout(wheel, seconds) bind(c)
            import; type(c_ptr), value :: wheel; real(c_double), value :: seconds
        end function
        integer(c_int32_t) function wheel_read_profile_c(wheel, path, file) bind(c, name="contactd_wheel_read_profile")
            import; type(c_ptr), value :: wheel; character(c_char), intent(in) :: path(*), file(*)
        end function
        integer(c_size_t) function strlen(text) bind(c)
            import; type(c_ptr), value :: text
        end function
    end interface
end module contactd_calls
