! contactd in Fortran: the functions of contactd.h under their own names, and its enumerators. docs/c.md describes them.
!
!     use contactd
!     type(c_ptr) :: connection, contact
!     code = contactd_open("ipc:///run/contactd.sock", connection)
!     code = contactd_new(connection, contact)
!     code = contactd_set(contact, "friction.mu", 0.3d0)
!     if (code /= contactd_ok) print *, contactd_last_error(contact)
!
! Compile contactd_calls.f90 first. Texts are Fortran strings of any length. Arrays over the grid have the shape (nx, ny).
module contactd
    use, intrinsic :: iso_c_binding
    use contactd_calls
    implicit none

    integer(c_int32_t), parameter :: contactd_ok = 0, contactd_cancelled = 1, contactd_unknown = 2, &
        contactd_invalid_argument = 3, contactd_deadline_exceeded = 4, contactd_not_found = 5, &
        contactd_already_exists = 6, contactd_permission_denied = 7, contactd_resource_exhausted = 8, &
        contactd_failed_precondition = 9, contactd_aborted = 10, contactd_out_of_range = 11, &
        contactd_unimplemented = 12, contactd_internal = 13, contactd_unavailable = 14, &
        contactd_data_loss = 15, contactd_unauthenticated = 16
    integer(c_int32_t), parameter :: contactd_exterior = 0, contactd_adhesion = 1, contactd_slip = 2, contactd_flow = 3
    integer(c_int32_t), parameter :: contactd_log_debug = 0, contactd_log_info = 1, &
        contactd_log_warning = 2, contactd_log_error = 3

    private :: version_c, code_name_c, last_error_c, last_field_c, last_reason_c, open_c, set_keys_c
    private :: set_c, set_word_c, set_array_c, clear_c, get_c, get_word_c, get_array_c, length_c, want_c, path_c
    private :: set_table_c, get_frames_c, read_profile_c, creep_table_open_c, creep_table_info_c
    private :: strlen, text_of, copy_text

contains

    function contactd_version() result(text)
        character(:), allocatable :: text
        text = text_of(version_c())
    end function
    function contactd_code_name(code) result(text)
        integer(c_int32_t), intent(in) :: code
        character(:), allocatable :: text
        text = text_of(code_name_c(code))
    end function
    function contactd_last_error(handle) result(text)
        type(c_ptr), intent(in) :: handle
        character(:), allocatable :: text
        text = text_of(last_error_c(handle))
    end function
    function contactd_last_field(handle) result(text)
        type(c_ptr), intent(in) :: handle
        character(:), allocatable :: text
        text = text_of(last_field_c(handle))
    end function
    function contactd_last_reason(handle) result(text)
        type(c_ptr), intent(in) :: handle
        character(:), allocatable :: text
        text = text_of(last_reason_c(handle))
    end function
    integer(c_int32_t) function contactd_open(where, connection) result(code)
        character(*), intent(in) :: where
        type(c_ptr), intent(out) :: connection
        code = open_c(trim(where) // c_null_char, connection)
    end function
    integer(c_int32_t) function contactd_set_keys(connection, server_key, own_key) result(code)
        type(c_ptr), intent(in) :: connection
        character(*), intent(in) :: server_key, own_key
        code = set_keys_c(connection, trim(server_key) // c_null_char, trim(own_key) // c_null_char)
    end function
    ! Paths of fields, such as "patches[0].place.creepages.xi", number the entries of lists from 0, as in C.
    integer(c_int32_t) function contactd_set(handle, path, value) result(code)
        type(c_ptr), intent(in) :: handle
        character(*), intent(in) :: path
        real(c_double), intent(in) :: value
        code = set_c(handle, trim(path) // c_null_char, value)
    end function
    integer(c_int32_t) function contactd_set_word(handle, path, word) result(code)
        type(c_ptr), intent(in) :: handle
        character(*), intent(in) :: path, word
        code = set_word_c(handle, trim(path) // c_null_char, trim(word) // c_null_char)
    end function
    integer(c_int32_t) function contactd_clear(handle, path) result(code)
        type(c_ptr), intent(in) :: handle
        character(*), intent(in) :: path
        code = clear_c(handle, trim(path) // c_null_char)
    end function
    integer(c_int32_t) function contactd_get(handle, path, value) result(code)
        type(c_ptr), intent(in) :: handle
        character(*), intent(in) :: path
        real(c_double), intent(out) :: value
        code = get_c(handle, trim(path) // c_null_char, value)
    end function
    integer(c_int32_t) function contactd_get_word(handle, path, text) result(code)
        type(c_ptr), intent(in) :: handle
        character(*), intent(in) :: path
        character(*), intent(out) :: text
        character(c_char) :: buffer(len(text) + 1)
        code = get_word_c(handle, trim(path) // c_null_char, buffer, size(buffer, kind=c_int32_t))
        call copy_text(code, buffer, text)
    end function
    ! `values` may have any rank. Its first dimension contains the fields of an entry, or the elements along x.
    integer(c_int32_t) function contactd_set_array(handle, path, values, count) result(code)
        type(c_ptr), intent(in) :: handle
        character(*), intent(in) :: path
        integer(c_int32_t), intent(in) :: count
        real(c_double), intent(in) :: values(*)
        code = set_array_c(handle, trim(path) // c_null_char, values, count)
    end function
    integer(c_int32_t) function contactd_get_array(handle, path, values, count) result(code)
        type(c_ptr), intent(in) :: handle
        character(*), intent(in) :: path
        integer(c_int32_t), intent(in) :: count
        real(c_double), intent(out) :: values(*)
        code = get_array_c(handle, trim(path) // c_null_char, values, count)
    end function
    integer(c_int32_t) function contactd_length(handle, path, count) result(code)
        type(c_ptr), intent(in) :: handle
        character(*), intent(in) :: path
        integer(c_int32_t), intent(out) :: count
        code = length_c(handle, trim(path) // c_null_char, count)
    end function
    integer(c_int32_t) function contactd_want(handle, array, wanted) result(code)
        type(c_ptr), intent(in) :: handle
        character(*), intent(in) :: array
        integer(c_int32_t), intent(in) :: wanted
        code = want_c(handle, trim(array) // c_null_char, wanted)
    end function
    integer(c_int32_t) function contactd_path(handle, path, id) result(code)
        type(c_ptr), intent(in) :: handle
        character(*), intent(in) :: path
        integer(c_int32_t), intent(out) :: id
        code = path_c(handle, trim(path) // c_null_char, id)
    end function
    integer(c_int32_t) function contactd_set_table(contact, path, nx, ny, dx, dy, values, count) result(code)
        type(c_ptr), intent(in) :: contact
        character(*), intent(in) :: path
        integer(c_int32_t), intent(in) :: nx, ny, count
        real(c_double), intent(in) :: dx, dy, values(*)
        code = set_table_c(contact, trim(path) // c_null_char, nx, ny, dx, dy, values, count)
    end function
    integer(c_int32_t) function contactd_get_frames(contact, body, y, z, angle, length) result(code)
        type(c_ptr), intent(in) :: contact
        character(*), intent(in) :: body
        integer(c_int32_t), intent(in) :: length
        real(c_double), intent(out) :: y(*), z(*), angle(*)
        code = get_frames_c(contact, trim(body) // c_null_char, y, z, angle, length)
    end function
    integer(c_int32_t) function contactd_read_profile(handle, path, file) result(code)
        type(c_ptr), intent(in) :: handle
        character(*), intent(in) :: path, file
        code = read_profile_c(handle, trim(path) // c_null_char, trim(file) // c_null_char)
    end function
    integer(c_int32_t) function contactd_creep_table_open(path, nu, table) result(code)
        character(*), intent(in) :: path
        real(c_double), intent(in) :: nu
        type(c_ptr), intent(out) :: table
        code = creep_table_open_c(trim(path) // c_null_char, nu, table)
    end function
    integer(c_int32_t) function contactd_creep_table_info(table, nu, ratios, text) result(code)
        type(c_ptr), intent(in) :: table
        real(c_double), intent(out) :: nu, ratios(2)
        character(*), intent(out) :: text
        character(c_char) :: buffer(len(text) + 1)
        code = creep_table_info_c(table, nu, ratios, buffer, size(buffer, kind=c_int32_t))
        call copy_text(code, buffer, text)
    end function

    function text_of(pointer) result(text)
        type(c_ptr), intent(in) :: pointer
        character(:), allocatable :: text
        character(c_char), pointer :: characters(:)
        integer :: i
        call c_f_pointer(pointer, characters, [strlen(pointer)])
        allocate (character(size(characters)) :: text)
        do i = 1, size(characters)
            text(i:i) = characters(i)
        end do
    end function

    subroutine copy_text(code, buffer, text)
        integer(c_int32_t), intent(in) :: code
        character(c_char), intent(in) :: buffer(:)
        character(*), intent(out) :: text
        integer :: i
        text = ""
        if (code /= contactd_ok) return
        do i = 1, len(text)
            if (buffer(i) == c_null_char) return
            text(i:i) = buffer(i)
        end do
    end subroutine

end module contactd
