// Programs that are not ours and read our files.
#pragma once

#include <QByteArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStandardPaths>
#include <QStringList>
#include <QTest>

/// Output of such a program; fails the test where it is missing or unhappy.
inline QByteArray run(const QString& program, const QStringList& arguments) {
    if (QStandardPaths::findExecutable(program).isEmpty()) {
        QTest::qFail(qPrintable(program + " is missing: apt install gdal-bin pngcheck"), __FILE__, __LINE__);
        return {};
    }
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(program, arguments);
    const bool ended = process.waitForFinished(60'000);
    const QByteArray output = process.readAll();
    if (!ended || process.exitCode() != 0)
        QTest::qFail(qPrintable(program + " is not content: " + output), __FILE__, __LINE__);
    return output;
}

/// The object that such a program prints, perhaps below warnings.
inline QJsonObject runForJson(const QString& program, const QStringList& arguments) {
    const QByteArray output = run(program, arguments);
    return QJsonDocument::fromJson(output.mid(output.indexOf('{'))).object();
}

/// The first of the files that ends so; empty: none does.
inline QString ending(const QStringList& files, const QString& suffix) {
    for (const QString& file : files) {
        if (file.endsWith(suffix))
            return file;
    }
    return {};
}
