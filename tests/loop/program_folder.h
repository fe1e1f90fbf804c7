// A folder in which tests write files and run usar-mission.
#pragma once

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>

namespace usar::test {

/// Makes the folder, and removes it in the end.
class ProgramFolder {
public:
    struct Ended {
        int exit_code = -1;
        QJsonObject summary; ///< last line of standard output
        QByteArray err;
    };

    static QString program() { return QString(USAR_BINARY_DIR) + "/bin/usar-mission"; }
    static constexpr int patience_ms = 100000;

    QString path(const QString& name = {}) const { return folder_.filePath(name); }

    /// Runs the program in the folder. One that does not end has the exit code -1.
    Ended run(const QStringList& arguments) const {
        QProcess process;
        process.setWorkingDirectory(folder_.path());
        process.start(program(), arguments);
        if (!process.waitForFinished(patience_ms))
            return {};
        const QByteArray out = process.readAllStandardOutput().trimmed();
        return {process.exitCode(), QJsonDocument::fromJson(out.mid(out.lastIndexOf('\n') + 1)).object(),
                process.readAllStandardError()};
    }

    void write(const QString& name, const QByteArray& text) const {
        QFile file(path(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
            qFatal("%s cannot be written", qPrintable(name));
    }

private:
    QTemporaryDir folder_;
};

/// A mission that takes a second or two.
inline const QByteArray small_mission =
    R"({ "name": "Small", "area": { "x": -8, "y": -6, "width": 16, "height": 12 } })";

} // namespace usar::test
