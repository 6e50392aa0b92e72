! The cases of wheel_cases.py, in a file, through the Fortran module; wheel_telling.py says what stands in a line.
!
!     congruence-wheel-fortran ipc:///run/contactd.sock cases.txt
program wheel_driver
    use contactd
    use answers, only: need, arrays
    use wheel_answers
    use words
    implicit none
    type(c_ptr) :: place, wheel
    integer :: unit
    ! What a slice takes over: the line that set the profile of wheel and rail last; and the slices that there are.
    character(1000) :: profiles(2), last_line
    integer :: slices(2)

    wheel = c_null_ptr
    call open_cases(place, unit)
    do while (next_line(unit, last_line))
        call take()
    end do
    if (c_associated(wheel)) call need(contactd_wheel_free(wheel))
    call need(contactd_close(place))

contains

    ! --- what a line says

    ! The words from i on as numbers.
    function all_numbers(i) result(made)
        integer, intent(in) :: i
        real(c_double) :: made(count - i)
        integer :: n
        made = [(number(n), n=i, count - 1)]
    end function

    function body(i) result(path)
        integer, intent(in) :: i
        character(18) :: path
        path = "setup.bodies.upper"
        if (word(i) == "wheel") path = "setup.bodies.lower"
    end function

    ! What went wrong first.
    integer(c_int32_t) function first(codes)
        integer(c_int32_t), intent(in) :: codes(:)
        integer :: i
        first = contactd_ok
        do i = size(codes), 1, -1
            if (codes(i) /= contactd_ok) first = codes(i)
        end do
    end function

    ! --- setters

    integer(c_int32_t) function set(path, i) result(code)
        character(*), intent(in) :: path
        integer, intent(in) :: i
        code = contactd_set(wheel, path, number(i))
    end function

    ! The numbers behind the word, each into one of the fields.
    integer(c_int32_t) function set_all(above, fields) result(code)
        character(*), intent(in) :: above, fields(:)
        integer :: i
        code = first([(set(above // trim(fields(i)), i), i=1, size(fields))])
    end function

    integer(c_int32_t) function set_array(path, i) result(code)
        character(*), intent(in) :: path
        integer, intent(in) :: i
        code = contactd_set_array(wheel, path, all_numbers(i), int(count - i, c_int32_t))
    end function

    ! A keyword where the line has 0 or 1.
    integer(c_int32_t) function choose(path, zero, one) result(code)
        character(*), intent(in) :: path, zero, one
        if (whole(1) /= 0) then
            code = contactd_set_word(wheel, path, one)
        else
            code = contactd_set_word(wheel, path, zero)
        end if
    end function

    integer(c_int32_t) function set_profile_at(path) result(code)
        character(*), intent(in) :: path
        code = contactd_ok
        select case (word(0))
        case ("rail_60e1"); code = set(path // ".rail_60e1.inclination", 1)
        case ("points"); code = set_array(path // ".points", 2)
        case ("arc", "cone")
            if (word(0) == "arc") code = set(path // ".arc.radius", 2)
            code = first([code, set(path // "." // trim(word(0)) // ".slope", count - 3), &
                set_array(path // "." // trim(word(0)) // ".ends", count - 2)])
        case default; code = -1
        end select
    end function

    integer(c_int32_t) function set_profile() result(code)
        if (word(0) == "rail_60e1" .or. word(1) == "rail") then
            code = set_profile_at("setup.rail")
            if (code /= -1) profiles(2) = last_line
        else
            code = set_profile_at("setup.wheel")
            if (code /= -1) profiles(1) = last_line
        end if
    end function

    integer(c_int32_t) function add_slice(of, list, field) result(code)
        integer, intent(in) :: of
        character(*), intent(in) :: list, field
        character(100) :: path
        write (path, "(a, i0, a)") list // "[", slices(of), "]"
        slices(of) = slices(of) + 1
        code = set(trim(path) // field, 1)
        if (code /= contactd_ok .or. profiles(of) == "") return
        call split(profiles(of))
        code = set_profile_at(trim(path) // ".profile")
    end function

    integer(c_int32_t) function set_springs() result(code)
        code = contactd_clear(wheel, "setup.track.springs")
        if (number(1) /= 0) code = first([code, set("setup.track.springs.y", 1)])
        if (number(2) /= 0) code = first([code, set("setup.track.springs.z", 2)])
    end function

    integer(c_int32_t) function set_tolerance() result(code)
        character(40) :: above
        above = "setup.settings." // trim(word(1))
        if (word(1) == "force") above = "setup.force"
        code = first([set(trim(above) // ".tolerance", 2), set(trim(above) // ".max_iterations", 3)])
    end function

    integer(c_int32_t) function set_up() result(code)
        select case (word(0))
        case ("side", "model", "conformal"); code = contactd_set_word(wheel, "setup." // trim(word(0)), word(1))
        case ("track"); code = set_all("setup.track.", [character(12) :: "gauge", "gauge_height", "cant"])
        case ("rail_origin"); code = set_all("setup.track.rail_origin.", ["y", "z"])
        case ("roller"); code = set("setup.track.roller_radius", 1)
        case ("springs"); code = set_springs()
        case ("wheelset")
            code = set_all("setup.wheelset.", &
                [character(20) :: "flange_back_distance", "flange_back_position", "nominal_radius"])
        case ("material"); code = first([set(body(1) // ".G", 2), set(body(1) // ".nu", 3)])
        case ("rigid"); code = contactd_set(wheel, body(1) // ".rigid", 1d0)
        case ("mu"); code = set("setup.friction.mu", 1)
        case ("mu_by_angle")
            code = first([set_array("setup.friction.mu", 2), set("setup.friction.along_profile", 1)])
        case ("kinetic")
            code = first([contactd_set_word(wheel, "setup.friction.kinetic.law", word(1)), &
                set("setup.friction.kinetic.mu", 2), set("setup.friction.kinetic.slip_velocity", 3)])
        case ("frictionless"); code = contactd_clear(wheel, "setup.friction")
        case ("elements"); code = set_all("setup.", ["dx", "dy", "dq"])
        case ("patch_rules")
            code = set_all("setup.patches.", [character(17) :: "angle_separate", "distance_separate", &
                "distance_combine", "distance_turn", "locus_step"])
        case ("bilinear"); code = choose("setup.wheel_surface", "exact", "bilinear")
        case ("slip_of_surfaces"); code = choose("setup.rigid_slip", "plane", "surfaces")
        case ("mesh_search"); code = choose("setup.patches.search", "locus", "mesh")
        case ("tolerance"); code = set_tolerance()
        case ("add_slice"); code = add_slice(2, "setup.rail_slices", ".x")
        case ("add_wheel_slice"); code = add_slice(1, "setup.wheel_slices", ".angle")
        case ("clear_wheel_slices")
            slices(1) = 0
            code = contactd_clear(wheel, "setup.wheel_slices")
        case default; code = set_profile()
        end select
    end function

    integer(c_int32_t) function move() result(code)
        select case (word(0))
        case ("position"); code = set_all("state.position.", [character(4) :: "y", "z", "roll", "yaw"])
        case ("x"); code = set("state.position.x", 1)
        case ("pitch_angle"); code = set("state.position.pitch", 1)
        case ("velocity"); code = set_array("state.velocity", 1)
        case ("deviation"); code = set_all("state.rail.", [character(4) :: "y", "z", "roll"])
        case ("deviation_rate")
            code = set_all("state.rail.", [character(13) :: "y_velocity", "z_velocity", "roll_velocity"])
        case ("rail_forces"); code = set_all("state.rail.", ["Fy", "Fz"])
        case ("roller_pitch", "Fz", "Fx", "derivatives"); code = set("state." // trim(word(0)), 1)
        case ("clear_forces"); code = first([contactd_clear(wheel, "state.Fz"), contactd_clear(wheel, "state.Fx")])
        case default; code = -1
        end select
    end function

    subroutine solve()
        write (*, "(a)", advance="no") trim(name) // " solve"
        if (refused == contactd_ok) call note(wheel, contactd_step_again(wheel))
        if (refused /= contactd_ok) then
            call tell_refusal()
        else
            call tell_wheel(wheel)
        end if
        write (*, "()")
        refused = contactd_ok
    end subroutine

    subroutine take()
        integer(c_int32_t) :: code
        integer :: array
        select case (word(0))
        case ("case")
            if (c_associated(wheel)) call need(contactd_wheel_free(wheel))
            call need(contactd_wheel_new(place, wheel))
            refused = contactd_ok
            name = word(1)
            profiles = ""
            slices = 0
            do array = 1, size(arrays)
                call need(contactd_want(wheel, arrays(array), 1))
            end do
        case ("solve")
            call solve()
        case default
            code = move()
            if (code == -1) code = set_up()
            call note(wheel, code)
        end select
    end subroutine
end program wheel_driver
