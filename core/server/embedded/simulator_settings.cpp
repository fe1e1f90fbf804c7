#include "core/server/embedded/simulator_settings.h"

#include <cmath>

#include "core/base/numbers.h"
#include "core/server/embedded/simulator_files.h"

namespace usar::server {

namespace {

constexpr Seconds physics_step{0.004};                                           ///< of sim::SimulationOptions
const QStringList image_types{"raw", "superb", "good", "normal", "fair", "bad"}; // In the order of link::ImageType.

Result<void> readSpeed(const std::string& text, SimulatorSettings& settings) {
    if (text == "max") {
        settings.pace = Pace::Fast;
        return {};
    }
    const std::optional<double> factor = readNumber(text);
    if (!factor || !std::isfinite(*factor) || *factor < 0.0 || *factor > 10000.0)
        return failure("'" + text + "' is no speed", "--speed", "Give a factor such as 1 or 10, max, or 0 for paused");
    settings.pace = *factor > 0.0 ? Pace::Factor : Pace::Paused;
    settings.factor = *factor > 0.0 ? *factor : 1.0;
    return {};
}

Result<long long> readWhole(const QString& words, const QString& option, long long most) {
    const std::string text = words.toStdString();
    const std::optional<long long> value = readInteger(text);
    if (!value || *value < 0 || *value > most)
        return failure("'" + text + "' is not a whole number from 0 to " + std::to_string(most),
                       "--" + option.toStdString(), "Give such a number");
    return *value;
}

Result<Seconds> readSeconds(const QString& words, const QString& option, double least, double most) {
    const std::string text = words.toStdString();
    const std::optional<double> value = readNumber(text);
    if (!value || !(*value >= least && *value <= most))
        return failure("'" + text + "' is not a time from " + shortest(least) + " to " + shortest(most) + " s",
                       "--" + option.toStdString(), "Give such a number");
    return Seconds{*value};
}

Result<void> readTick(const QString& words, SimulatorSettings& settings) {
    const auto tick = readSeconds(words, "tick", physics_step.count(), 10.0);
    if (!tick)
        return tl::unexpected(tick.error());
    const double steps = std::round(*tick / physics_step);
    if (std::abs(steps * physics_step.count() - tick->count()) > 1e-9)
        return failure("'" + words.toStdString() + "' is no multiple of 0.004 s, a step of the physics", "--tick",
                       "Give one such as 0.1 or 0.2");
    settings.tick = *tick;
    return {};
}

Result<void> readTimes(const QCommandLineParser& parser, SimulatorSettings& settings) {
    const auto patience = readSeconds(parser.value("lockstep-patience"), "lockstep-patience", 0.1, 86400.0);
    if (!patience)
        return tl::unexpected(patience.error());
    settings.lockstep_patience = std::chrono::milliseconds(std::lround(patience->count() * 1e3));
    auto battery = readBattery(parser.value("battery"));
    if (!battery)
        return tl::unexpected(battery.error());
    settings.battery_life = *battery;
    return parser.isSet("tick") ? readTick(parser.value("tick"), settings) : Result<void>();
}

std::vector<std::pair<QString, quint16*>> portOptions(SimulatorSettings& settings) {
    return {{"port", &settings.port},
            {"image-port", &settings.channels.image},
            {"wireless-port", &settings.channels.wireless},
            {"comserver-port", &settings.channels.comserver},
            {"cominterface-port", &settings.channels.cominterface}};
}

} // namespace

Result<quint16> readPort(const QString& text, const QString& option) {
    return readWhole(text, option, 65535).map([](long long port) { return static_cast<quint16>(port); });
}

Result<std::optional<Seconds>> readBattery(const QString& text) {
    if (text == "robot")
        return std::nullopt;
    return readSeconds(text, "battery", 1.0, 1e7).map([](Seconds life) { return std::optional(life); });
}

Result<Access> readAccess(const QCommandLineParser& parser) {
    return Access::make(parser.value("bind"), parser.values("allow"));
}

QList<QCommandLineOption> sharedOptions() {
    return {
        {"bind", "address on which the simulator listens, for programs on other machines; needs --allow", "ADDRESS",
         "127.0.0.1"},
        {"allow", "network that may connect to it, such as 192.168.1.0/24; repeat for more; needs --bind", "NETWORK"},
        {"battery", "how long a robot's battery lasts; robot: what the robot's file says", "SECONDS|robot",
         QString::number(sim::survey_battery_life.count())}};
}

QList<QCommandLineOption> simulatorOptions() {
    const auto usual = [](quint16 port) { return QString::number(port); };
    return sharedOptions() +
           QList<QCommandLineOption>{
               {"world", "world that comes with the program, or a world folder", "NAME|FOLDER", "tall_test"},
               {"port", "TCP port; 0 chooses a free one", "N", usual(protocol::usual_port::bot)},
               {"image-port", "TCP port of the image server; 0 chooses a free one", "N",
                usual(protocol::usual_port::image)},
               {"image-type", "how pictures are sent: raw, or as JPEG from superb to bad quality",
                image_types.join('|'), "good"},
               {"image-first", "the image server sends its first picture without being asked, as the oldest one did"},
               {"wireless-port", "TCP port of the wireless server", "N", usual(protocol::usual_port::wireless)},
               {"comserver-port", "TCP port of the ComServer", "N", usual(protocol::usual_port::com_server)},
               {"cominterface-port", "TCP port for the questions of another program's wireless server", "N",
                usual(protocol::usual_port::com_interface)},
               {"seed", "equal seeds and equal commands give equal bytes", "N", "1"},
               {"tick", "time between two STA, a multiple of 0.004; usually 0.2, with --profile udk 0.1", "SECONDS"},
               {"lockstep-patience", "how long other clients wait for a client that says LOCKSTEP and no STEP",
                "SECONDS", "10"},
               {"profile", "dialect of the server", "ut2004|udk", "ut2004"},
               {"resume", "snapshot to continue from; world, seed, profile and faults come from it",
                "SNAPSHOT.usarsnap"},
               {"save", "file for a snapshot that is saved when the program ends", "FILE"},
               {"fault", "fault to inject, see below; repeat for more", "TEXT"},
               {"speed", "times real time; 0 is paused", "N|max", "1"},
               usage::helpOption(),
               usage::versionOption()};
}

usage::Program simulatorProgram() {
    const QString purpose = "Simulates a world for USARSim clients on loopback TCP.";
    return {.name = "usar-sim",
            .title = "simulate robots for USARSim clients",
            .description = {"usar-sim is the simulator of USAR Mission Control alone. It speaks the protocol of "
                            "USARSim over TCP, so any client of that simulator can use it.",
                            "It runs until Ctrl+C."},
            .verbs = {{.name = {},
                       .calls = {"usar-sim [options]"},
                       .purpose = purpose,
                       .options = simulatorOptions(),
                       .exit_codes = {{0, "it was stopped"}, {2, "bad use or input, or a port that is taken"}}}},
            .sections = {faultSection(),
                         {.title = "Files", .entries = {{"SNAPSHOT.usarsnap", "a moment to go on from"}}},
                         {.title = "Examples",
                          .entries = {{"usar-sim --world tall_test --port 3000", "simulate the hills of tall_test"},
                                      {"usar-sim --bind 0.0.0.0 --allow 192.168.1.0/24",
                                       "let the machines of one network connect"}}}},
            .see_also = {"mission-control", "usar-mission"}};
}

Result<SimulatorSettings> readSimulatorSettings(const QCommandLineParser& parser) {
    if (!parser.positionalArguments().isEmpty())
        return failure("unknown argument '" + parser.positionalArguments().first().toStdString() + "'", "",
                       "See usar-sim --help");
    SimulatorSettings settings;
    settings.world = parser.value("world");
    settings.resume = parser.value("resume");
    settings.save = parser.value("save");
    for (const auto& [option, port] : portOptions(settings)) {
        const auto number = readPort(parser.value(option), option);
        if (!number)
            return tl::unexpected(number.error());
        *port = *number;
    }
    const auto seed = readWhole(parser.value("seed"), "seed", INT64_MAX);
    if (!seed)
        return tl::unexpected(seed.error());
    settings.seed = static_cast<std::uint64_t>(*seed);
    if (const auto speed = readSpeed(parser.value("speed").toStdString(), settings); !speed)
        return tl::unexpected(speed.error());
    const QString profile = parser.value("profile").toLower();
    if (profile != "ut2004" && profile != "udk")
        return failure("'" + profile.toStdString() + "' is no profile", "--profile", "Say ut2004 or udk");
    settings.profile = profile == "udk" ? protocol::Dialect::Udk : protocol::Dialect::Ut2004;
    auto faults = readFaults(parser.values("fault"));
    if (!faults)
        return tl::unexpected(faults.error());
    settings.faults = *std::move(faults);
    if (const auto read = readTimes(parser, settings); !read)
        return tl::unexpected(read.error());
    auto access = readAccess(parser);
    if (!access)
        return tl::unexpected(access.error());
    settings.access = *std::move(access);
    const auto type = static_cast<int>(image_types.indexOf(parser.value("image-type").toLower()));
    if (type < 0)
        return failure("'" + parser.value("image-type").toStdString() + "' is no type of picture", "--image-type",
                       "Say " + image_types.join(", ").toStdString());
    settings.images = {static_cast<link::ImageType>(type), parser.isSet("image-first")};
    return settings;
}

Result<std::unique_ptr<sim::Simulation>> makeSimulation(const SimulatorSettings& settings,
                                                        const std::function<void(const Error&)>& refused) {
    sim::RobotsRead robots = loadRobots();
    for (const Error& reason : robots.refused)
        refused(reason);
    auto catalog = std::make_shared<const sim::RobotCatalog>(std::move(robots.robots));
    if (!settings.resume.isEmpty())
        return resumeSimulation(settings.resume, std::move(catalog));
    auto world = loadWorld(settings.world);
    if (!world)
        return tl::unexpected(world.error());
    sim::SimulationOptions options{.seed = settings.seed,
                                   .profile = settings.profile,
                                   .battery_life = settings.battery_life,
                                   .robots = std::move(catalog),
                                   .faults = settings.faults,
                                   .world_source = settings.world.toStdString()};
    if (settings.profile == protocol::Dialect::Udk) { // The robot's state at 10 Hz, sensors at their intervals.
        options.tick /= 2.0;
        options.physics_steps_per_tick /= 2;
    }
    if (settings.tick) {
        options.tick = *settings.tick;
        options.physics_steps_per_tick = static_cast<int>(std::lround(*settings.tick / physics_step));
    }
    return sim::Simulation::make(std::move(*world), options);
}

} // namespace usar::server
