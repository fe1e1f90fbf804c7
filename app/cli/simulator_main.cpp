// usar-sim: runs the simulator alone, for any USARSim client.

#include <cmath>
#include <cstdio>
#include <optional>

#include <QCommandLineParser>
#include <QCoreApplication>

#include "app/host/quit_signals.h"
#include "core/base/numbers.h"
#include "core/protocol/usual_values.h"
#include "core/server/embedded/simulator_channels.h"
#include "core/server/embedded/simulator_files.h"
#include "core/server/simulator_server.h"
#include "core/sim/simulation.h"

namespace {

using usar::server::Pace;

constexpr int bad_use = 2;
const QStringList image_types{"raw", "superb", "good", "normal", "fair", "bad"}; // In the order of link::ImageType.

struct Settings {
    QString world;
    quint16 port = usar::protocol::usual_port::bot;
    usar::server::ChannelPorts channels;
    usar::server::ImageServerOptions images;
    std::uint64_t seed = 1;
    Pace pace = Pace::Factor;
    double factor = 1.0;
    QString resume;
    QString save;
    std::vector<usar::sim::Fault> faults;
    usar::protocol::Dialect profile = usar::protocol::Dialect::Ut2004;
};

usar::Result<void> readSpeed(const std::string& text, Settings& settings) {
    if (text == "max") {
        settings.pace = Pace::Fast;
        return {};
    }
    const std::optional<double> factor = usar::readNumber(text);
    if (!factor || !std::isfinite(*factor) || *factor < 0.0 || *factor > 10000.0)
        return usar::failure("'" + text + "' is no speed", "--speed",
                             "Give a factor such as 1 or 10, max, or 0 for paused");
    settings.pace = *factor > 0.0 ? Pace::Factor : Pace::Paused;
    settings.factor = *factor > 0.0 ? *factor : 1.0;
    return {};
}

usar::Result<long long> readWhole(const QCommandLineParser& parser, const QString& option, long long most) {
    const std::string text = parser.value(option).toStdString();
    const std::optional<long long> value = usar::readInteger(text);
    if (!value || *value < 0 || *value > most)
        return usar::failure("'" + text + "' is not a whole number from 0 to " + std::to_string(most),
                             "--" + option.toStdString());
    return *value;
}

std::vector<std::pair<QString, quint16*>> channelOptions(usar::server::ChannelPorts& ports) {
    return {{"image-port", &ports.image},
            {"wireless-port", &ports.wireless},
            {"comserver-port", &ports.comserver},
            {"cominterface-port", &ports.cominterface}};
}

usar::Result<Settings> readSettings(const QCommandLineParser& parser) {
    if (!parser.positionalArguments().isEmpty())
        return usar::failure("unknown argument '" + parser.positionalArguments().first().toStdString() + "'", "",
                             "See usar-sim --help");
    Settings settings;
    settings.world = parser.value("world");
    const auto port = readWhole(parser, "port", 65535);
    const auto seed = readWhole(parser, "seed", INT64_MAX);
    const auto speed = readSpeed(parser.value("speed").toStdString(), settings);
    if (!port)
        return tl::unexpected(port.error());
    if (!seed)
        return tl::unexpected(seed.error());
    if (!speed)
        return tl::unexpected(speed.error());
    const QString profile = parser.value("profile").toLower();
    if (profile != "ut2004" && profile != "udk")
        return usar::failure("'" + profile.toStdString() + "' is no profile", "--profile", "Say ut2004 or udk");
    settings.profile = profile == "udk" ? usar::protocol::Dialect::Udk : usar::protocol::Dialect::Ut2004;
    auto faults = usar::server::readFaults(parser.values("fault"));
    if (!faults)
        return tl::unexpected(faults.error());
    settings.faults = *std::move(faults);
    settings.resume = parser.value("resume");
    settings.save = parser.value("save");
    const auto type = static_cast<int>(image_types.indexOf(parser.value("image-type").toLower()));
    if (type < 0)
        return usar::failure("'" + parser.value("image-type").toStdString() + "' is no type of picture", "--image-type",
                             "Say " + image_types.join(", ").toStdString());
    settings.images = {static_cast<usar::link::ImageType>(type), parser.isSet("image-first")};
    settings.port = static_cast<quint16>(*port);
    for (const auto& [option, channel] : channelOptions(settings.channels)) {
        const auto number = readWhole(parser, option, 65535);
        if (!number)
            return tl::unexpected(number.error());
        *channel = static_cast<quint16>(*number);
    }
    settings.seed = static_cast<std::uint64_t>(*seed);
    return settings;
}

void addOptions(QCommandLineParser& parser) {
    parser.addHelpOption();
    parser.setApplicationDescription("Simulates a world for USARSim clients on loopback TCP.\n\n" +
                                     usar::server::faultHelp());
    parser.addVersionOption();
    parser.addOptions(
        {{"world", "World that comes with the program, or a world folder.", "name|folder", "tall_test"},
         {"port", "TCP port; 0 chooses a free one.", "number", QString::number(usar::protocol::usual_port::bot)},
         {"image-port", "TCP port of the image server; 0 chooses a free one.", "number",
          QString::number(usar::protocol::usual_port::image)},
         {"image-type", "How pictures are sent: raw, or a JPEG from superb to bad.", "type", "good"},
         {"image-first", "The image server sends its first picture unasked, as the oldest one did."},
         {"wireless-port", "TCP port of the wireless server.", "number",
          QString::number(usar::protocol::usual_port::wireless)},
         {"comserver-port", "TCP port of the ComServer.", "number",
          QString::number(usar::protocol::usual_port::com_server)},
         {"cominterface-port", "TCP port that a wireless server of somebody else's asks.", "number",
          QString::number(usar::protocol::usual_port::com_interface)},
         {"seed", "Equal seeds and equal commands give equal bytes.", "number", "1"},
         {"profile", "How the server speaks: ut2004 or udk.", "profile", "ut2004"},
         {"resume", "A snapshot to go on from; world, seed, profile and faults are its own.", "file"},
         {"save", "Where a snapshot is saved when the program ends.", "file"},
         {"fault", "Something that goes wrong; again for more. See above.", "text"},
         {"speed", "Times real time: a factor, max, or 0 for paused.", "factor", "1"}});
}

int complain(const usar::Error& error) {
    std::fprintf(stderr, "usar-sim: %s\n", error.text().c_str());
    return bad_use;
}

usar::Result<std::unique_ptr<usar::sim::Simulation>> makeSimulation(const Settings& settings) {
    usar::sim::RobotsRead robots = usar::server::loadRobots();
    for (const usar::Error& refused : robots.refused)
        complain(refused);
    auto catalog = std::make_shared<const usar::sim::RobotCatalog>(std::move(robots.robots));
    if (!settings.resume.isEmpty())
        return usar::server::resumeSimulation(settings.resume, std::move(catalog));
    auto world = usar::server::loadWorld(settings.world);
    if (!world)
        return tl::unexpected(world.error());
    usar::sim::SimulationOptions options;
    options.seed = settings.seed;
    options.profile = settings.profile;
    options.faults = settings.faults;
    options.world_source = settings.world.toStdString();
    if (settings.profile == usar::protocol::Dialect::Udk) { // The robot's state at 10 Hz, sensors at their intervals.
        options.tick /= 2.0;
        options.physics_steps_per_tick /= 2;
    }
    options.robots = std::move(catalog);
    return usar::sim::Simulation::make(std::move(*world), options);
}

} // namespace

int main(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    QCoreApplication::setApplicationName("usar-sim");
    QCommandLineParser parser;
    addOptions(parser);
    if (!parser.parse(QCoreApplication::arguments()))
        return complain({parser.errorText().toStdString(), "", "See usar-sim --help"});
    if (parser.isSet("version"))
        parser.showVersion();
    if (parser.isSet("help"))
        parser.showHelp();
    const auto settings = readSettings(parser);
    if (!settings)
        return complain(settings.error());
    auto simulation = makeSimulation(*settings);
    if (!simulation)
        return complain(simulation.error());
    const std::string level = (*simulation)->world().name;

    usar::server::SimulatorServer server(std::move(*simulation));
    QObject::connect(&server, &usar::server::SimulatorServer::logged,
                     [](const QString& sentence) { std::fprintf(stderr, "%s\n", sentence.toLocal8Bit().constData()); });
    const auto port = server.listen(settings->port);
    if (!port)
        return complain(port.error());
    server.setPace(settings->pace, settings->factor);
    const usar::server::OpenChannels channels =
        usar::server::openChannels(server, settings->channels, settings->images);
    for (const QString& sentence : channels.sentences)
        std::fprintf(stderr, "%s\n", sentence.toLocal8Bit().constData());
    std::printf("%s on 127.0.0.1:%u - connect a USARSim client there, or: nc -C 127.0.0.1 %u; Ctrl+C ends\n",
                level.c_str(), static_cast<unsigned>(*port), static_cast<unsigned>(*port));
    std::printf("Pictures of its cameras on 127.0.0.1:%u\n", static_cast<unsigned>(channels.ports.image));
    for (const usar::sim::Simulation::Orphan& robot : server.simulation().orphans())
        std::printf("%s %s waits, and time with it, for a client that says INIT with its name\n",
                    robot.class_name.c_str(), robot.name.c_str());
    std::fflush(stdout);

    usar::app::QuitSignals signals_;
    QObject::connect(&signals_, &usar::app::QuitSignals::quit, &application, &QCoreApplication::quit);
    const int exit_code = application.exec();
    if (settings->save.isEmpty())
        return exit_code;
    const auto saved = usar::server::saveSnapshot(server.simulation(), settings->save);
    return saved ? exit_code : complain(saved.error());
}
