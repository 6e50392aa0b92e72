#include "file_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <memory>
#include <numbers>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "given/checks.hpp"
#include "given/coefficients_file.hpp"
#include "given/covered_digits.hpp"
#include "given/given_area.hpp"
#include "given/given_bodies.hpp"
#include "given/given_friction.hpp"
#include "given/given_profile.hpp"
#include "given/not_covered.hpp"
#include "types/number_text.hpp"

namespace contactd::cases {
namespace {

constexpr Units units_of_files = units_mm_on_body_1;
constexpr std::uintmax_t most_coefficients_bytes = std::uintmax_t{1} << 31;  ///< size of 4 million offsets

/// Holds the values of a case by their names.
struct Values {
    const ContactCase& read;

    int digit(std::string_view name) const { return read.digits.find(name)->second; }
    bool has(std::string_view name) const { return read.values.contains(name); }
    int integer(std::string_view name) const { return std::get<int>(read.values.find(name)->second); }
    double real(std::string_view name) const { return std::get<double>(read.values.find(name)->second); }
    /// Returns the value, or zero if no case of the file contained it.
    double real_or_none(std::string_view name) const { return has(name) ? real(name) : 0; }
    const std::string& text(std::string_view name) const {
        return std::get<std::string>(read.values.find(name)->second);
    }
    const std::vector<double>& list(std::string_view name) const {
        return *std::get<ContactNumbers>(read.values.find(name)->second);
    }
    std::vector<double> reals(std::initializer_list<const char*> names) const {
        std::vector<double> found;
        for (const char* name : names) found.push_back(real(name));
        return found;
    }
    void append(std::vector<double>& to, std::initializer_list<const char*> names) const {
        for (const char* name : names) to.push_back(real(name));
    }
};

void set_digits(Given& given, const Values& of, bool on_rails) {
    const auto set = [&](int Digits::* digit, int value) { set_digit(given.digits, digit, value, on_rails); };
    set(&Digits::previous, of.digit("P"));
    set(&Digits::bound, of.digit("B"));
    set(&Digits::tangential, of.digit("T"));
    set(&Digits::normal, of.digit("N"));
    set(&Digits::force, of.digit("F"));
    set(&Digits::influence, of.integer("INFLCF"));
    set(&Digits::material, of.digit("M"));
    set(&Digits::heat, of.digit("H"));
    set(&Digits::estimate, of.digit("I"));
    if (!on_rails) return;
    set(&Digits::configuration, of.digit("C1"));
    set(&Digits::discretisation, of.integer("DISCNS"));
    set(&Digits::variant, of.has("VARIANT") ? of.integer("VARIANT") : Digits{}.variant);
}

/// Sets the options of the solvers. In a file, MAXOUT = 1 means one outer iteration for dissimilar bodies, and MAXGS =
/// 999, the default, means no limit. INISLP remains effective if G selects another solver.
void set_solvers(Given& given, const Values& of) {
    constexpr int no_limit = 999;
    const int maxgs = of.integer("MAXGS"), maxout = of.integer("MAXOUT");
    given.solvers = solver_settings(of.real("EPS"), maxgs, maxout);
    if (maxgs == no_limit) {
        const ContactSettings own;
        given.solvers.normal.max_iterations = own.normal.max_iterations;
        given.solvers.tangential.max_iterations = own.tangential.max_iterations;
    }
    given.one_outer_iteration = maxout == 1;
    if (of.has("INISLP")) given.starts_in_slip = of.integer("INISLP") < 0;
}

void set_bodies(Given& given, const Values& of) {
    std::vector<double> numbers = of.reals({"POISS1", "POISS2", "GG1", "GG2"});
    const int method = of.digit("M");
    given.sheet = of.digit("B") == 1 ? of.real("FLXZ") : 0;
    if (method == material::viscoelastic) of.append(numbers, {"FG1", "FG2", "TC1", "TC2"});
    if (method == material::layered) of.append(numbers, {"GG3", "LAYTHK", "TAU_C0", "K_TAU"});
    if (method == material::fastsim || method == material::fastrip) of.append(numbers, {"K0", "ALFA", "BETA"});
    set_material(given, method, numbers, units_of_files);
    const auto damping = of.read.digits.find("M2");
    if (damping != of.read.digits.end() && damping->second != 0)
        require_undamped(of.real_or_none("CDAMPN"), of.real_or_none("CDAMPT"));
    if (of.digit("H") == 0) return;
    numbers = of.reals({"BKTEMP1", "HEATCP1", "LAMBDA1", "DENS1", "BKTEMP2", "HEATCP2", "LAMBDA2", "DENS2"});
    if (method == material::layered) of.append(numbers, {"BETAPL"});
    given.heat = thermal_bodies(numbers, units_of_files);
}

/// Returns the numbers of the law of a set, with those of its memory.
std::vector<double> numbers_of_set(const Values& of, const ByName<double>& set, int law) {
    if (law == law::coulomb) return {set.at("FSTAT"), set.at("FSTAT")};
    std::vector<double> numbers;
    if (law == law::by_temperature)
        for (const char* name : {"FREF", "TREF", "DFHEAT", "DTHEAT"}) numbers.push_back(set.at(name));
    else
        for (const char* name : {"FKIN", "F1", "SABSH1", "F2", "SABSH2"}) numbers.push_back(set.at(name));
    of.append(numbers, {"MEMDST", "MEM_S0"});
    return numbers;
}

void set_friction(Given& given, const Values& of) {
    const int law = of.integer("FRCLAW"), varies = of.integer("VARFRC");
    given.digits.friction_law = law;
    const ContactFrictionSets& sets = *of.read.friction;
    if (varies == varies::nowhere) {
        given.friction = uniform_friction(law, numbers_of_set(of, sets.front(), law), units_of_files);
        return;
    }
    constexpr std::array places_by{"", "ALPHVF", "SVF", "IY"};
    std::vector<FrictionAt> places;
    for (const auto& set : sets)
        places.push_back({set.at(places_by.at(static_cast<std::size_t>(varies))), numbers_of_set(of, set, law)});
    given.friction = varying_friction(law, varies, places, units_of_files);
}

/// Names the values of the potential contact after MX and MY, by IPOTCN.
const std::map<int, std::vector<const char*>> names_of_areas{
    {-6, {"AA", "BNEG", "BPOS", "SCALE"}}, {-5, {"AA", "BB", "SCALE"}},   {-4, {"A1", "BB", "SCALE"}},
    {-3, {"AA", "BB", "SCALE"}},           {-2, {"A1", "AOB", "SCALE"}},  {-1, {"A1", "B1", "SCALE"}},
    {1, {"XL", "YL", "DX", "DY"}},         {2, {"XL", "YL", "XH", "YH"}}, {3, {"XC1", "YC1", "DX", "DY"}},
    {4, {"XC1", "YC1", "XCM", "YCM"}}};

Distance distance_of(const Values& of) {
    const int base = of.integer("IBASE");
    std::vector<double> numbers;
    if (base == 1) numbers = of.reals({"B1", "B2", "B3", "B4", "B5", "B6"});
    if (base == 3) numbers = of.reals({"B1", "B2", "B3", "B4", "B5", "B6", "B7", "B8"});
    if (base == 9) numbers = of.list("GAP");
    if (base == 2) {
        const std::vector<double>& heights = of.list("HEIGHTS");
        numbers = {static_cast<double>(heights.size())};
        of.append(numbers, {"XM", "RM", "Y1", "DY1"});
        numbers.insert(numbers.end(), heights.begin(), heights.end());
    }
    return given_distance(base, std::move(numbers), units_of_files);
}

Planform planform_of(const Values& of) {
    const auto box = [](double xl, double xh, double yl, double yh) { return RegionLimits{{xl, xh}, {yl, yh}}; };
    switch (of.integer("IPLAN")) {
        case 2: {
            Quadratic conic;
            std::ranges::copy(of.reals({"P1", "P2", "P3", "P4", "P5", "P6"}), conic.b.begin());
            return conic;
        }
        case 3:
            return std::vector{box(of.real("XL1"), of.real("XH1"), of.real("YL1"), of.real("YH1")),
                               box(of.real("XL2"), of.real("XH2"), of.real("YL2"), of.real("YH2"))};
        case 4: {
            ContactRegions regions;
            const std::vector<double>&ends = of.list("PATCH_LIMITS"), &factors = of.list("PATCH_FACTORS");
            for (std::size_t i = 0; i + 3 < ends.size(); i += 4)
                regions.limits.push_back(box(ends[i], ends[i + 1], ends[i + 2], ends[i + 3]));
            const std::size_t n = regions.limits.size();
            regions.shares.assign(n * n, 1);
            std::size_t next = 0;
            for (std::size_t row = 0; row < n; ++row)
                for (std::size_t column = row + 1; column < n; ++column)
                    regions.shares[row * n + column] = regions.shares[column * n + row] = factors[next++];
            return regions;
        }
        default:
            return {};
    }
}

void set_area(Given& given, const Values& of) {
    const int kind = of.integer("IPOTCN");
    const auto names = names_of_areas.find(kind);
    if (names == names_of_areas.end())
        throw NotCovered(Subject::other,
                         "IPOTCN = " + std::to_string(kind) + " is not supported. Use -6 to -1 or 1 to 4.");
    std::vector<double> numbers{double(of.integer("MX")), double(of.integer("MY"))};
    for (const char* name : names->second) numbers.push_back(of.real(name));
    if (kind < 0) {
        given.area = hertz_area(kind, numbers, units_of_files);
        return;
    }
    given.area = potential_contact(kind, numbers, units_of_files);
    given.distance = distance_of(of);
    given.planform = planform_of(of);
}

void set_extra_slip(Given& given, const Values& of) {
    constexpr int of_elements = 9;
    const bool is_kept = of.digit("E") != 0 && of.has("EXRHS");  // A first case with E = 1 has nothing to keep.
    set_digit(given.digits, &Digits::extra_slip, is_kept ? of.integer("EXRHS") : 0, false);
    if (given.digits.extra_slip == of_elements) given.extra_slip = GivenSlip{of.list("SLIP_X"), of.list("SLIP_Y"), 1};
}

/// Returns whether CONTACT rolls along x: in steady rolling, unless ConvexGS solves it (G = 2), and in simplified
/// theories.
bool rolls_along_x(const Values& of) {
    const int method = of.digit("M");
    const bool is_simplified = method == material::fastsim || method == material::fastrip;
    return is_simplified || (of.digit("T") == 3 && of.integer("GAUSEI") != 2);
}

constexpr double near_direction = 0.01;  ///< (rad)

bool goes_back(double chi) {
    return std::abs(std::abs(std::remainder(chi, 2 * std::numbers::pi)) - std::numbers::pi) < near_direction;
}

void set_motion(Given& given, const Values& of) {
    if (of.digit("T") == 0) return;
    given.spin_x = of.real("SPINXO");
    given.spin_y = of.real("SPINYO");
    const int force = of.digit("F");
    given.motion = GivenMotion{force == 0 ? of.real("CKSI") : 0, force == 2 ? 0 : of.real("CETA"), of.real("CPHI"), 1};
    if (force > 0) given.force = RelativeForce{of.real("FX"), force == 2 ? of.real("FY") : 0};
    if (of.digit("T") == 1) {
        given.time_step = 1;
    } else {
        given.spin_offset = of.has("FACPHI") ? of.real("FACPHI") : Given{}.spin_offset;
        given.chi = rolls_along_x(of) ? (goes_back(of.real("CHI")) ? std::numbers::pi : 0) : of.real("CHI");
        given.dq = positive(of.real("DQ"), "DQ");
        given.velocity = positive(std::abs(of.real("VELOC")), "The magnitude of VELOC");
    }
    set_extra_slip(given, of);
}

void set_both(Given& given, const Values& of, bool on_rails) {
    set_digits(given, of, on_rails);
    set_solvers(given, of);
    set_bodies(given, of);
}

std::string text_of_coefficients(const NamedFiles& files, const std::string& name) {
    try {
        return files.text(name, most_coefficients_bytes);
    } catch (const NotCovered& error) {
        throw NotCovered(Subject::coefficients, error.what());
    }
}

void set_coefficients(Given& given, const Values& of, const NamedFiles& files) {
    const std::string name = with_slashes(of.text("CFNAME")), text = text_of_coefficients(files, name);
    const auto& [upper, lower] = *given.materials;
    const double G = 2 / (1 / upper.G + 1 / lower.G);
    given.coefficients =
        std::make_shared<const GivenIcs>(read_coefficients(text, name, upper.G == lower.G ? upper.G : G));
}

GivenSurface surface_of(const Values& of, const char* name, const std::string& prefix, bool wheel,
                        const NamedFiles& files) {
    const auto real = [&](const char* option) { return of.real(prefix + option); };
    const auto integer = [&](const char* option) { return of.integer(prefix + option); };
    ProfileOptions options = profile_options({integer("MIRRORY"), integer("MIRRORZ"), integer("ISMOOTH"), real("SCALE"),
                                              real("SMOOTH"), real("KINKHIGH"), real("KINKLOW"), real("KINKWID")},
                                             units_of_files);
    options.wheel = wheel;
    return profile_from_file(of.text(name), options, files).surface;
}

void set_track(GivenRail& rail, const Values& of) {
    GivenTrack& track = rail.track;
    track.gauge_height = of.real("GAUGHT");
    if (track.gauge_height > 0) {
        track.gauge = positive(of.real("GAUGWD"), "GAUGWD");
    } else {
        track.rail_y = of.real("RAILY0");
        track.rail_z = of.real("RAILZ0");
    }
    track.cant = of.real_or_none("CANT");
    track.roller_radius = of.real_or_none("NOMRADR");
    track.curvature = of.real_or_none("CURV");
    rail.deviation.y = of.real_or_none("DYRAIL");
    rail.deviation.z = of.real_or_none("DZRAIL");
    rail.deviation.roll = of.real_or_none("DROLLR");
    rail.deviation.y_velocity = of.real_or_none("VYRAIL");
    rail.deviation.z_velocity = of.real_or_none("VZRAIL");
    rail.deviation.roll_velocity = of.real_or_none("VROLLR");
    if (of.digit("F") != 3) return;
    track.spring_y = of.real("KYRAIL");
    track.spring_force_y = of.real("FYRAIL");
    track.spring_z = of.real("KZRAIL");
    track.spring_force_z = of.real("FZRAIL");
    if (track.spring_y < 0 || track.spring_z < 0)
        throw NotCovered(Subject::input, "The stiffnesses KYRAIL and KZRAIL must be at least 0.");
}

/// Sets the wheelset. Deviations of an earlier case remain effective for every digit E. The pitch deviation is zero,
/// because CONTACT does not rotate a round wheel by it.
void set_wheelset(GivenRail& rail, const Values& of) {
    const bool on_roller = of.digit("C1") >= 4;
    rail.wheelset = {of.real("FBDIST"), of.real("FBPOS"), positive(of.real("NOMRADW"), "NOMRADW")};
    rail.position = {
        of.real("Y_WS"), of.real_or_none("Z_WS"), of.real("ROLL"), of.real("YAW"), of.real(on_roller ? "X_WS" : "S_WS"),
        of.real("PITCH")};
    rail.velocity = {of.real(on_roller ? "RPITCH" : "VS"),
                     of.real("VY"),
                     of.real("VZ"),
                     of.real("VROLL"),
                     of.real("VYAW"),
                     of.real_or_none("VPITCH")};
    rail.velocity_length = 1;
    const auto by = [&](const char* name) { return of.real_or_none(name); };
    rail.flexibility = {by("DXWHL"), by("DYWHL"), by("DZWHL"), by("DROLLW"), by("DYAWW"), 0,
                        by("VXWHL"), by("VYWHL"), by("VZWHL"), by("VROLLW"), by("VYAWW"), by("VPITCHW")};
}

}  // namespace

void set_basic_case(Given& given, const ContactCase& read, const NamedFiles& files) {
    const Values of{read};
    set_both(given, of, false);
    if (given.digits.influence == 9) set_coefficients(given, of, files);
    set_friction(given, of);
    set_area(given, of);
    set_motion(given, of);
    (of.digit("N") == 0 ? given.pen : given.fn) = of.real(of.digit("N") == 0 ? "PEN" : "FN");
}

std::string warning_of_direction(const ContactCase& read) {
    constexpr int transient = 2;
    const Values of{read};
    if (of.digit("T") < transient || !rolls_along_x(of)) return {};
    const double chi = of.real("CHI");
    if (goes_back(chi) || std::abs(std::remainder(chi, 2 * std::numbers::pi)) < near_direction) return {};
    return "CHI = " + number_text(chi) +
           " rad has no effect, and the bodies roll along x: steady rolling across x requires G = 2, and simplified "
           "models have no other direction.";
}

void set_rail_case(Given& given, GivenRail& rail, const ContactCase& read, const NamedFiles& files) {
    const Values of{read};
    set_both(given, of, true);
    given.most_elements = std::clamp(of.integer("NPOT_MAX"), least_patch_elements, most_patch_elements);
    if (of.digit("T") != 0) set_friction(given, of);
    rail.elements = rail_elements(-1, of.reals({"DX", "DS", "A_SEP", "D_SEP", "D_COMB", "D_TURN"}), units_of_files);
    rail.dq = positive(of.real("DQREL"), "DQREL");
    rail.rail = surface_of(of, "RFNAME", "RAIL_", false, files);
    rail.wheel = surface_of(of, "WFNAME", "WHEEL_", true, files);
    set_track(rail, of);
    set_wheelset(rail, of);
    if (of.digit("N") == 1) rail.Fz = positive(of.real("FZ"), "FZ");
    if (of.digit("F") == 1) rail.Fx = of.real("FX");
}

}  // namespace contactd::cases
