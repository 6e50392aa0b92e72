! The functions of contactd.h for wheels on rails as a compiler sees them, for the module contactd, which users take.
module contactd_wheel_calls
    use, intrinsic :: iso_c_binding
    implicit none

    interface
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
        integer(c_int32_t) function contactd_wheel_set_side(wheel, side) bind(c)
            import; type(c_ptr), value :: wheel; integer(c_int32_t), value :: side
        end function
        integer(c_int32_t) function contactd_wheel_set_s1002(wheel) bind(c)
            import; type(c_ptr), value :: wheel
        end function
        integer(c_int32_t) function contactd_wheel_set_rail_60e1(wheel, inclination) bind(c)
            import; type(c_ptr), value :: wheel; real(c_double), value :: inclination
        end function
        integer(c_int32_t) function contactd_wheel_set_arc(wheel, body, radius, slope, from, to) bind(c)
            import; type(c_ptr), value :: wheel; integer(c_int32_t), value :: body
            real(c_double), value :: radius, slope, from, to
        end function
        integer(c_int32_t) function contactd_wheel_set_cone(wheel, body, slope, from, to) bind(c)
            import; type(c_ptr), value :: wheel; integer(c_int32_t), value :: body
            real(c_double), value :: slope, from, to
        end function
        integer(c_int32_t) function contactd_wheel_set_points(wheel, body, y, z, count, smoothing_length) bind(c)
            import; type(c_ptr), value :: wheel; integer(c_int32_t), value :: body
            real(c_double), intent(in) :: y(*), z(*); integer(c_int32_t), value :: count
            real(c_double), value :: smoothing_length
        end function
        integer(c_int32_t) function wheel_set_file_c( &
            wheel, body, path, smoothing_length) bind(c, name="contactd_wheel_set_file")
            import; type(c_ptr), value :: wheel; integer(c_int32_t), value :: body
            character(c_char), intent(in) :: path(*); real(c_double), value :: smoothing_length
        end function
        integer(c_int32_t) function contactd_wheel_add_slice(wheel, x) bind(c)
            import; type(c_ptr), value :: wheel; real(c_double), value :: x
        end function
        integer(c_int32_t) function contactd_wheel_clear_slices(wheel) bind(c)
            import; type(c_ptr), value :: wheel
        end function
        integer(c_int32_t) function contactd_wheel_add_wheel_slice(wheel, angle) bind(c)
            import; type(c_ptr), value :: wheel; real(c_double), value :: angle
        end function
        integer(c_int32_t) function contactd_wheel_clear_wheel_slices(wheel) bind(c)
            import; type(c_ptr), value :: wheel
        end function
        integer(c_int32_t) function contactd_wheel_set_track(wheel, gauge, gauge_height, cant) bind(c)
            import; type(c_ptr), value :: wheel; real(c_double), value :: gauge, gauge_height, cant
        end function
        integer(c_int32_t) function contactd_wheel_set_rail_origin(wheel, y, z) bind(c)
            import; type(c_ptr), value :: wheel; real(c_double), value :: y, z
        end function
        integer(c_int32_t) function contactd_wheel_set_roller(wheel, radius) bind(c)
            import; type(c_ptr), value :: wheel; real(c_double), value :: radius
        end function
        integer(c_int32_t) function contactd_wheel_set_springs(wheel, y, z) bind(c)
            import; type(c_ptr), value :: wheel; real(c_double), value :: y, z
        end function
        integer(c_int32_t) function contactd_wheel_set_wheelset( &
            wheel, flange_back_distance, flange_back_position, nominal_radius) bind(c)
            import; type(c_ptr), value :: wheel
            real(c_double), value :: flange_back_distance, flange_back_position, nominal_radius
        end function
        integer(c_int32_t) function contactd_wheel_set_material(wheel, body, G, nu) bind(c)
            import; type(c_ptr), value :: wheel; integer(c_int32_t), value :: body; real(c_double), value :: G, nu
        end function
        integer(c_int32_t) function contactd_wheel_set_rigid(wheel, body) bind(c)
            import; type(c_ptr), value :: wheel; integer(c_int32_t), value :: body
        end function
        integer(c_int32_t) function contactd_wheel_set_model(wheel, model) bind(c)
            import; type(c_ptr), value :: wheel; integer(c_int32_t), value :: model
        end function
        integer(c_int32_t) function contactd_wheel_set_mu(wheel, mu) bind(c)
            import; type(c_ptr), value :: wheel; real(c_double), value :: mu
        end function
        integer(c_int32_t) function contactd_wheel_set_mu_by_angle(wheel, angle, mu, count, along_profile) bind(c)
            import; type(c_ptr), value :: wheel; real(c_double), intent(in) :: angle(*), mu(*)
            integer(c_int32_t), value :: count, along_profile
        end function
        integer(c_int32_t) function contactd_wheel_set_kinetic(wheel, law, mu, slip_velocity) bind(c)
            import; type(c_ptr), value :: wheel; integer(c_int32_t), value :: law
            real(c_double), value :: mu, slip_velocity
        end function
        integer(c_int32_t) function contactd_wheel_set_frictionless(wheel) bind(c)
            import; type(c_ptr), value :: wheel
        end function
        integer(c_int32_t) function contactd_wheel_set_elements(wheel, dx, dy, dq) bind(c)
            import; type(c_ptr), value :: wheel; real(c_double), value :: dx, dy, dq
        end function
        integer(c_int32_t) function contactd_wheel_set_patch_rules( &
            wheel, angle_separate, distance_separate, distance_combine, &
            distance_turn, locus_step) bind(c)
            import; type(c_ptr), value :: wheel
            real(c_double), value :: angle_separate, distance_separate, distance_combine, distance_turn, locus_step
        end function
        integer(c_int32_t) function contactd_wheel_set_bilinear(wheel, bilinear) bind(c)
            import; type(c_ptr), value :: wheel; integer(c_int32_t), value :: bilinear
        end function
        integer(c_int32_t) function contactd_wheel_set_slip_of_surfaces(wheel, of_surfaces) bind(c)
            import; type(c_ptr), value :: wheel; integer(c_int32_t), value :: of_surfaces
        end function
        integer(c_int32_t) function contactd_wheel_set_mesh_search(wheel, mesh) bind(c)
            import; type(c_ptr), value :: wheel; integer(c_int32_t), value :: mesh
        end function
        integer(c_int32_t) function contactd_wheel_set_conformal(wheel, conformal) bind(c)
            import; type(c_ptr), value :: wheel; integer(c_int32_t), value :: conformal
        end function
        integer(c_int32_t) function contactd_wheel_set_tolerance(wheel, solver, tolerance, max_iterations) bind(c)
            import; type(c_ptr), value :: wheel; integer(c_int32_t), value :: solver
            real(c_double), value :: tolerance; integer(c_int32_t), value :: max_iterations
        end function
        integer(c_int32_t) function contactd_wheel_set_position(wheel, y, z, roll, yaw) bind(c)
            import; type(c_ptr), value :: wheel; real(c_double), value :: y, z, roll, yaw
        end function
        integer(c_int32_t) function contactd_wheel_set_x(wheel, x) bind(c)
            import; type(c_ptr), value :: wheel; real(c_double), value :: x
        end function
        integer(c_int32_t) function contactd_wheel_set_pitch_angle(wheel, pitch) bind(c)
            import; type(c_ptr), value :: wheel; real(c_double), value :: pitch
        end function
        integer(c_int32_t) function contactd_wheel_set_velocity(wheel, x, y, z, roll, yaw, pitch) bind(c)
            import; type(c_ptr), value :: wheel; real(c_double), value :: x, y, z, roll, yaw, pitch
        end function
        integer(c_int32_t) function contactd_wheel_set_deviation(wheel, y, z, roll) bind(c)
            import; type(c_ptr), value :: wheel; real(c_double), value :: y, z, roll
        end function
        integer(c_int32_t) function contactd_wheel_set_deviation_rate(wheel, y, z, roll) bind(c)
            import; type(c_ptr), value :: wheel; real(c_double), value :: y, z, roll
        end function
        integer(c_int32_t) function contactd_wheel_set_rail_forces(wheel, Fy, Fz) bind(c)
            import; type(c_ptr), value :: wheel; real(c_double), value :: Fy, Fz
        end function
        integer(c_int32_t) function contactd_wheel_set_roller_pitch(wheel, pitch) bind(c)
            import; type(c_ptr), value :: wheel; real(c_double), value :: pitch
        end function
        integer(c_int32_t) function contactd_wheel_set_Fz(wheel, Fz) bind(c, name="contactd_wheel_set_Fz")
            import; type(c_ptr), value :: wheel; real(c_double), value :: Fz
        end function
        integer(c_int32_t) function contactd_wheel_set_Fx(wheel, Fx) bind(c, name="contactd_wheel_set_Fx")
            import; type(c_ptr), value :: wheel; real(c_double), value :: Fx
        end function
        integer(c_int32_t) function contactd_wheel_clear_forces(wheel) bind(c)
            import; type(c_ptr), value :: wheel
        end function
        integer(c_int32_t) function contactd_wheel_want(wheel, array, wanted) bind(c)
            import; type(c_ptr), value :: wheel; integer(c_int32_t), value :: array, wanted
        end function
        integer(c_int32_t) function contactd_wheel_want_derivatives(wheel, wanted) bind(c)
            import; type(c_ptr), value :: wheel; integer(c_int32_t), value :: wanted
        end function
        integer(c_int32_t) function contactd_wheel_get_motion(wheel, z, pitch) bind(c)
            import; type(c_ptr), value :: wheel; real(c_double), intent(out) :: z, pitch
        end function
        integer(c_int32_t) function contactd_wheel_get_roll(wheel, roll) bind(c)
            import; type(c_ptr), value :: wheel; real(c_double), intent(out) :: roll
        end function
        integer(c_int32_t) function contactd_wheel_get_rail_shift(wheel, y, z) bind(c)
            import; type(c_ptr), value :: wheel; real(c_double), intent(out) :: y, z
        end function
        integer(c_int32_t) function contactd_wheel_get_clearance(wheel, clearance) bind(c)
            import; type(c_ptr), value :: wheel; real(c_double), intent(out) :: clearance
        end function
        integer(c_int32_t) function contactd_wheel_get_forces(wheel, coordinates, forces) bind(c)
            import; type(c_ptr), value :: wheel; integer(c_int32_t), value :: coordinates
            real(c_double), intent(out) :: forces(6)
        end function
        integer(c_int32_t) function contactd_wheel_get_derivative(wheel, by, forces) bind(c)
            import; type(c_ptr), value :: wheel; integer(c_int32_t), value :: by
            real(c_double), intent(out) :: forces(6)
        end function
        integer(c_int32_t) function contactd_wheel_get_converged(wheel, converged) bind(c)
            import; type(c_ptr), value :: wheel; integer(c_int32_t), intent(out) :: converged
        end function
        integer(c_int32_t) function contactd_wheel_get_evidence( &
            wheel, solver, iterations, residual, converged) bind(c)
            import; type(c_ptr), value :: wheel; integer(c_int32_t), value :: solver
            integer(c_int32_t), intent(out) :: iterations; real(c_double), intent(out) :: residual
            integer(c_int32_t), intent(out) :: converged
        end function
        integer(c_int32_t) function contactd_wheel_get_warnings(wheel, count) bind(c)
            import; type(c_ptr), value :: wheel; integer(c_int32_t), intent(out) :: count
        end function
        integer(c_int32_t) function wheel_get_warning_c( &
            wheel, index, text, length) bind(c, name="contactd_wheel_get_warning")
            import; type(c_ptr), value :: wheel; integer(c_int32_t), value :: index
            character(c_char), intent(out) :: text(*); integer(c_int32_t), value :: length
        end function
        integer(c_int32_t) function contactd_wheel_get_patches(wheel, count) bind(c)
            import; type(c_ptr), value :: wheel; integer(c_int32_t), intent(out) :: count
        end function
        integer(c_int32_t) function contactd_wheel_get_place(wheel, patch, x, y, z, angle) bind(c)
            import; type(c_ptr), value :: wheel; integer(c_int32_t), value :: patch
            real(c_double), intent(out) :: x, y, z, angle
        end function
        integer(c_int32_t) function contactd_wheel_get_grid(wheel, patch, nx, ny, dx, dy, x0, y0) bind(c)
            import; type(c_ptr), value :: wheel; integer(c_int32_t), value :: patch
            integer(c_int32_t), intent(out) :: nx, ny; real(c_double), intent(out) :: dx, dy, x0, y0
        end function
        integer(c_int32_t) function contactd_wheel_get_rows(wheel, patch, y, z, angle, length) bind(c)
            import; type(c_ptr), value :: wheel; integer(c_int32_t), value :: patch
            real(c_double), intent(out) :: y(*), z(*), angle(*); integer(c_int32_t), value :: length
        end function
        integer(c_int32_t) function contactd_wheel_get_creepages(wheel, patch, xi, eta, phi, velocity) bind(c)
            import; type(c_ptr), value :: wheel; integer(c_int32_t), value :: patch
            real(c_double), intent(out) :: xi, eta, phi, velocity
        end function
        integer(c_int32_t) function contactd_wheel_get_radii( &
            wheel, patch, wheel_along, wheel_across, rail_along, rail_across) bind(c)
            import; type(c_ptr), value :: wheel; integer(c_int32_t), value :: patch
            real(c_double), intent(out) :: wheel_along, wheel_across, rail_along, rail_across
        end function
        integer(c_int32_t) function contactd_wheel_get_contact_forces(wheel, patch, Fn, Fx, Fs, Mn) bind(c)
            import; type(c_ptr), value :: wheel; integer(c_int32_t), value :: patch
            real(c_double), intent(out) :: Fn, Fx, Fs, Mn
        end function
        integer(c_int32_t) function contactd_wheel_get_patch_forces(wheel, patch, coordinates, forces) bind(c)
            import; type(c_ptr), value :: wheel; integer(c_int32_t), value :: patch, coordinates
            real(c_double), intent(out) :: forces(6)
        end function
        integer(c_int32_t) function contactd_wheel_get_pressure(wheel, patch, approach, pmax) bind(c)
            import; type(c_ptr), value :: wheel; integer(c_int32_t), value :: patch
            real(c_double), intent(out) :: approach, pmax
        end function
        integer(c_int32_t) function contactd_wheel_get_areas(wheel, patch, in_contact, adhesion, slip) bind(c)
            import; type(c_ptr), value :: wheel; integer(c_int32_t), value :: patch
            real(c_double), intent(out) :: in_contact, adhesion, slip
        end function
        integer(c_int32_t) function contactd_wheel_get_frictional_power(wheel, patch, power) bind(c)
            import; type(c_ptr), value :: wheel; integer(c_int32_t), value :: patch
            real(c_double), intent(out) :: power
        end function
        integer(c_int32_t) function contactd_wheel_get_counts( &
            wheel, patch, in_contact, adhesion, slip, border) bind(c)
            import; type(c_ptr), value :: wheel; integer(c_int32_t), value :: patch
            integer(c_int32_t), intent(out) :: in_contact, adhesion, slip, border
        end function
        integer(c_int32_t) function contactd_wheel_get_array(wheel, patch, array, values, length) bind(c)
            import; type(c_ptr), value :: wheel; integer(c_int32_t), value :: patch, array
            real(c_double), intent(out) :: values(*); integer(c_int32_t), value :: length
        end function
        integer(c_int32_t) function contactd_wheel_get_division(wheel, patch, division, length) bind(c)
            import; type(c_ptr), value :: wheel; integer(c_int32_t), value :: patch
            integer(c_int32_t), intent(out) :: division(*); integer(c_int32_t), value :: length
        end function
    end interface
end module contactd_wheel_calls
