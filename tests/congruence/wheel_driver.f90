! The cases of wheel_cases.py, in a file, through the Fortran module; wheel_telling.py says what stands in a line.
!
!     congruence-wheel-fortran ipc:///run/contactd.sock cases.txt
program wheel_driver
    use contactd
    use answers, only: need
    use wheel_answers
    use words
    implicit none
    type(c_ptr) :: place, wheel
    integer :: unit

    wheel = c_null_ptr
    call open_cases(place, unit)
    do while (next_line(unit))
        call take()
    end do
    if (c_associated(wheel)) call need(contactd_wheel_free(wheel))
    call need(contactd_close(place))

contains

    ! --- what a line says

    ! Every second word from i on.
    function each_second(i) result(made)
        integer, intent(in) :: i
        real(c_double) :: made((count - i + 1) / 2)
        integer :: n
        made = [(number(i + 2 * n), n=0, size(made) - 1)]
    end function

    integer(c_int32_t) function body(i)
        integer, intent(in) :: i
        body = place_of(i, [character(5) :: "wheel", "rail"])
    end function

    ! --- setters

    integer(c_int32_t) function set_profile() result(code)
        select case (word(0))
        case ("rail_60e1"); code = contactd_wheel_set_rail_60e1(wheel, number(1))
        case ("arc")
            code = contactd_wheel_set_arc(wheel, body(1), number(2), number(3), number(4), number(5))
        case ("cone"); code = contactd_wheel_set_cone(wheel, body(1), number(2), number(3), number(4))
        case ("points")
            code = contactd_wheel_set_points(wheel, body(1), each_second(2), each_second(3), &
                int(size(each_second(3)), c_int32_t), 0d0)
        case ("add_slice"); code = contactd_wheel_add_slice(wheel, number(1))
        case ("add_wheel_slice"); code = contactd_wheel_add_wheel_slice(wheel, number(1))
        case ("clear_wheel_slices"); code = contactd_wheel_clear_wheel_slices(wheel)
        case default; code = -1
        end select
    end function

    integer(c_int32_t) function set_up() result(code)
        select case (word(0))
        case ("side"); code = contactd_wheel_set_side(wheel, place_of(1, [character(5) :: "left", "right"]))
        case ("track"); code = contactd_wheel_set_track(wheel, number(1), number(2), number(3))
        case ("rail_origin"); code = contactd_wheel_set_rail_origin(wheel, number(1), number(2))
        case ("roller"); code = contactd_wheel_set_roller(wheel, number(1))
        case ("springs"); code = contactd_wheel_set_springs(wheel, number(1), number(2))
        case ("wheelset"); code = contactd_wheel_set_wheelset(wheel, number(1), number(2), number(3))
        case ("material"); code = contactd_wheel_set_material(wheel, body(1), number(2), number(3))
        case ("rigid"); code = contactd_wheel_set_rigid(wheel, body(1))
        case ("model")
            code = contactd_wheel_set_model(wheel, place_of(1, [character(7) :: "full", "hertz", "fastsim"]))
        case ("mu"); code = contactd_wheel_set_mu(wheel, number(1))
        case ("mu_by_angle")
            code = contactd_wheel_set_mu_by_angle(wheel, each_second(2), each_second(3), &
                int(size(each_second(3)), c_int32_t), whole(1))
        case ("kinetic")
            code = contactd_wheel_set_kinetic(wheel, place_of(1, [character(11) :: "linear", "exponential"]), &
                number(2), number(3))
        case ("frictionless"); code = contactd_wheel_set_frictionless(wheel)
        case ("elements"); code = contactd_wheel_set_elements(wheel, number(1), number(2), number(3))
        case ("patch_rules")
            code = contactd_wheel_set_patch_rules(wheel, number(1), number(2), number(3), number(4), number(5))
        case ("bilinear"); code = contactd_wheel_set_bilinear(wheel, whole(1))
        case ("slip_of_surfaces"); code = contactd_wheel_set_slip_of_surfaces(wheel, whole(1))
        case ("mesh_search"); code = contactd_wheel_set_mesh_search(wheel, whole(1))
        case ("conformal")
            code = contactd_wheel_set_conformal(wheel, place_of(1, [character(10) :: "off", "half_space", "rotated"]))
        case ("tolerance")
            code = contactd_wheel_set_tolerance(wheel, &
                place_of(1, [character(10) :: "normal", "tangential", "outer", "force"]), number(2), whole(3))
        case default; code = set_profile()
        end select
    end function

    integer(c_int32_t) function move() result(code)
        select case (word(0))
        case ("position"); code = contactd_wheel_set_position(wheel, number(1), number(2), number(3), number(4))
        case ("x"); code = contactd_set(wheel, "state.position.x", number(1))
        case ("pitch_angle"); code = contactd_wheel_set_pitch_angle(wheel, number(1))
        case ("velocity")
            code = contactd_wheel_set_velocity(wheel, number(1), number(2), number(3), number(4), number(5), number(6))
        case ("deviation"); code = contactd_wheel_set_deviation(wheel, number(1), number(2), number(3))
        case ("deviation_rate"); code = contactd_wheel_set_deviation_rate(wheel, number(1), number(2), number(3))
        case ("rail_forces"); code = contactd_wheel_set_rail_forces(wheel, number(1), number(2))
        case ("roller_pitch"); code = contactd_set(wheel, "state.roller_pitch", number(1))
        case ("Fz"); code = contactd_wheel_set_Fz(wheel, number(1))
        case ("Fx"); code = contactd_wheel_set_Fx(wheel, number(1))
        case ("clear_forces"); code = contactd_wheel_clear_forces(wheel)
        case ("derivatives"); code = contactd_wheel_want_derivatives(wheel, whole(1))
        case default; code = -1
        end select
    end function

    subroutine solve()
        write (*, "(a)", advance="no") trim(name) // " solve"
        if (refused == contactd_ok) call note(wheel, contactd_wheel_solve(wheel))
        if (refused /= contactd_ok) then
            call tell_refusal()
        else
            call tell_wheel(wheel)
        end if
        write (*, "()")
        refused = contactd_ok
    end subroutine

    subroutine take()
        integer(c_int32_t) :: array, code
        select case (word(0))
        case ("case")
            if (c_associated(wheel)) call need(contactd_wheel_free(wheel))
            call need(contactd_wheel_new(place, wheel))
            refused = contactd_ok
            name = word(1)
            do array = contactd_division, contactd_gap
                call need(contactd_wheel_want(wheel, array, 1))
            end do
        case ("solve")
            call solve()
        case default
            code = set_up()
            if (code == -1) code = move()
            call note(wheel, code)
        end select
    end subroutine
end program wheel_driver
