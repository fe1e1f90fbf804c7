#include "app/cli/server_files_verb.h"

#include <QCommandLineParser>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include "app/cli/console.h"
#include "core/campaign/plan/campaign_writer.h"
#include "core/mission/files/command_line.h"
#include "core/mission/runs/mission_runner.h"
#include "core/server/embedded/simulator_files.h"
#include "core/sim/servers/sensor_classes.h"
#include "core/sim/servers/server_reader.h"
#include "core/sim/servers/server_writer.h"

namespace usar::app {

namespace {

QList<QCommandLineOption> options() {
    return {{"merge", "a server's own file, into which the sensors are put; the result is written to FOLDER", "FILE"},
            {"check", "say what the robots of a server with this file lack; nothing is written", "FILE"},
            {"robot", "check this robot only, such as AirRobot", "NAME"},
            usage::helpOption()};
}

sim::RobotCatalog robots() {
    sim::RobotsRead read = server::loadRobots();
    for (const Error& refused : read.refused)
        complain(refused.text());
    return std::move(read.robots);
}

Result<std::string> textIn(const QString& path) {
    constexpr qint64 most_bytes = qint64(16) << 20;
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return failure(file.errorString().toStdString(), path.toStdString(), "Check the path");
    if (file.size() > most_bytes)
        return failure("this is larger than any such file", path.toStdString(), "Give a USARBot.ini");
    return file.readAll().toStdString();
}

Error inFile(const QString& path, const Error& error) {
    return {error.what, path.toStdString() + (error.where.empty() ? "" : ", section " + error.where), error.mend};
}

Result<int> write(const QString& path, const sim::ServerText& made) {
    const auto written = campaign::writeWhole(path, QByteArray::fromStdString(made.text));
    if (!written)
        return tl::unexpected(written.error());
    std::printf("%s\n", qPrintable(path));
    for (const std::string& sentence : made.left_out)
        tell("  " + sentence + ".\n");
    return 0;
}

QString pathOf(const QDir& folder, protocol::Dialect dialect) {
    const std::string_view name = sim::serverFileName(dialect);
    return folder.filePath(QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size())));
}

Result<int> writeBoth(const QDir& folder) {
    const sim::RobotCatalog catalog = robots();
    for (const protocol::Dialect dialect : {protocol::Dialect::Ut2004, protocol::Dialect::Udk})
        if (auto written = write(pathOf(folder, dialect), sim::writeServerFile(catalog, dialect)); !written)
            return written;
    return 0;
}

Result<int> merge(const QString& server_file, const QDir& folder) {
    const auto text = textIn(server_file);
    if (!text)
        return tl::unexpected(text.error());
    const auto server = sim::readServerFile(*text);
    if (!server)
        return tl::unexpected(inFile(server_file, server.error()));
    const QString result = folder.filePath(QFileInfo(server_file).fileName());
    if (QFileInfo(result).exists() && QFileInfo(result) == QFileInfo(server_file))
        return failure("this would replace the server's own file", result.toStdString(),
                       "Give another folder, and keep the original");
    const auto merged = sim::mergeServerFile(*text, robots(), server->dialect);
    if (!merged)
        return tl::unexpected(inFile(server_file, merged.error()));
    return write(result, *merged);
}

Result<int> check(const QString& server_file, const QString& robot) {
    const auto server = textIn(server_file).and_then([](const std::string& text) { return sim::readServerFile(text); });
    if (!server)
        return tl::unexpected(inFile(server_file, server.error()));
    const sim::RobotCatalog catalog = robots();
    if (!robot.isEmpty() && !sim::findRobot(catalog, robot.toStdString()))
        return failure("there is no such robot", robot.toStdString(), "See resources/robots/README.md for their names");
    int differences = 0;
    for (const sim::RobotModel& ours : catalog) {
        const bool asked = robot.isEmpty() ? server->robot(ours.class_name) != nullptr
                                           : &ours == sim::findRobot(catalog, robot.toStdString());
        for (const std::string& sentence : asked ? sim::differencesOf(ours, *server) : std::vector<std::string>()) {
            std::printf("%s\n", sentence.c_str());
            ++differences;
        }
    }
    return differences == 0 ? 0 : 1;
}

Result<int> run(const QStringList& arguments) {
    const std::string how =
        "Write usar-mission server-files [--merge FILE] FOLDER, or usar-mission server-files --check "
        "FILE [--robot NAME]";
    QCommandLineParser parser;
    if (const auto parsed = mission::parseArguments(parser, options(), arguments.mid(1), how); !parsed)
        return tl::unexpected(parsed.error());
    const QStringList folders = parser.positionalArguments();
    const bool checks = parser.isSet("check");
    if (folders.size() != (checks ? 0 : 1) || (checks && parser.isSet("merge")) || (!checks && parser.isSet("robot")))
        return failure("this is not how to call it", arguments.join(' ').toStdString(), how);
    if (checks)
        return check(parser.value("check"), parser.value("robot"));
    const QDir folder(folders.first());
    if (!folder.mkpath("."))
        return failure("this folder cannot be made", folders.first().toStdString(), "Choose another one");
    return parser.isSet("merge") ? merge(parser.value("merge"), folder) : writeBoth(folder);
}

} // namespace

usage::Verb serverFilesVerb() {
    return {.name = "server-files",
            .calls = {"usar-mission server-files [--merge FILE] FOLDER",
                      "usar-mission server-files --check FILE [--robot NAME]"},
            .purpose =
                "Makes configuration files for real USARSim servers from the robot files: USARBot.ini for UT2004 "
                "and DefaultUSAR.ini for UDK, with the sensors that the behaviors need.",
            .options = options(),
            .notes = {"Sentences on standard error say what a server cannot have."},
            .exit_codes = {{0, "the files were written, or the server's robots lack nothing"},
                           {1, "with --check, a robot lacks something"},
                           {2, "a file cannot be read or written, or bad use"}}};
}

int runServerFilesVerb(const QStringList& arguments) {
    const Result<int> exit_code = run(arguments);
    if (exit_code)
        return *exit_code;
    complain(exit_code.error().text());
    return mission::BadInput;
}

} // namespace usar::app
