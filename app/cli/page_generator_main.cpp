// usar-make-pages: writes the man pages, with the date of the version, and the completions of all programs below a
// folder, from their tables of options.
#include <cstdio>
#include <string>

#include <QDir>
#include <QFile>

#include "app/cli/behavior_host_program.h"
#include "app/cli/mission_program.h"
#include "core/base/result.h"
#include "core/base/version.h"
#include "core/server/embedded/simulator_settings.h"
#include "core/server/embedded/window_options.h"
#include "core/usage/bash_completion.h"
#include "core/usage/man_page.h"

namespace {

using namespace usar;

Result<void> write(const QDir& folder, const QString& name, const QByteArray& text) {
    QFile file(folder.filePath(name));
    if (QDir().mkpath(folder.path()) && file.open(QIODevice::WriteOnly) && file.write(text) == text.size() &&
        file.flush())
        return {};
    return failure(file.errorString().toStdString(), file.fileName().toStdString(), "Give it another folder");
}

Result<void> writePages(const QDir& folder, const QString& date) {
    const QString version = QString::fromStdString(std::string(usar::version()));
    for (const usage::Program& program :
         {app::missionProgram(), server::simulatorProgram(), server::windowProgram(), app::behaviorHostProgram()}) {
        const auto written =
            write(folder.filePath("man/man1"), program.name + ".1", usage::manPage(program, version, date))
                .and_then([&] {
                    return write(folder.filePath("bash-completion/completions"), program.name,
                                 usage::bashCompletion(program));
                });
        if (!written)
            return written;
    }
    return {};
}

} // namespace

int main(int argc, char** argv) {
    if (answersVersion(argc, argv))
        return 0;
    if (argc != 3) {
        std::fprintf(stderr, "usage: usar-make-pages FOLDER DATE\n");
        return 2;
    }
    const auto written = writePages(QDir(QString::fromLocal8Bit(argv[1])), argv[2]);
    if (!written)
        std::fprintf(stderr, "usar-make-pages: %s\n", written.error().text().c_str());
    return written ? 0 : 1;
}
