// usar-make-help: makes pages for a browser from our Markdown pages, each at its own place below a folder, with
// cmark-gfm as the reader.
#include <cstdio>
#include <string>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QProcess>

#include "core/base/result.h"
#include "core/base/version.h"
#include "core/usage/web_page.h"

namespace {

using namespace usar;

Result<QString> bodyOf(const QString& reader, const QString& path) {
    QProcess process;
    process.start(reader, {"-e", "table", "-e", "strikethrough", path});
    if (!process.waitForStarted())
        return failure("it cannot be started: " + process.errorString().toStdString(), reader.toStdString(),
                       "Install cmark-gfm");
    if (!process.waitForFinished() || process.exitStatus() != QProcess::NormalExit)
        return failure("cmark-gfm did not come to an end with it: " + process.errorString().toStdString(),
                       path.toStdString());
    if (process.exitCode() != 0)
        return failure("cmark-gfm ended with " + std::to_string(process.exitCode()) +
                           " and said: " + QString::fromUtf8(process.readAllStandardError()).trimmed().toStdString(),
                       path.toStdString());
    return QString::fromUtf8(process.readAllStandardOutput());
}

Result<void> write(const QString& path, const QByteArray& text) {
    QFile file(path);
    if (QDir().mkpath(QFileInfo(path).path()) && file.open(QIODevice::WriteOnly) && file.write(text) == text.size() &&
        file.flush())
        return {};
    return failure(file.errorString().toStdString(), path.toStdString(), "Give it another folder");
}

/// `page` is relative to both folders.
Result<void> makePage(const QString& reader, const QDir& source, const QDir& folder, const QString& page) {
    return bodyOf(reader, source.filePath(page)).and_then([&](const QString& body) {
        const QString root = QString("../").repeated(page.count('/'));
        QString target = page;
        target.replace(target.size() - 3, 3, ".html");
        return write(folder.filePath(target), usage::webPage(body, root).toUtf8());
    });
}

} // namespace

int main(int argc, char** argv) {
    if (answersVersion(argc, argv))
        return 0;
    QCoreApplication application(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.size() < 5) {
        std::fprintf(stderr, "usage: usar-make-help CMARK-GFM SOURCE-FOLDER FOLDER PAGE.md...\n");
        return 2;
    }
    for (const QString& page : arguments.mid(4))
        if (const auto made = makePage(arguments[1], QDir(arguments[2]), QDir(arguments[3]), page); !made) {
            std::fprintf(stderr, "usar-make-help: %s\n", made.error().text().c_str());
            return 1;
        }
    return 0;
}
