// The Debian packages are of the version and the date that the program says.
#include <QDate>
#include <QFile>
#include <QLocale>
#include <QRegularExpression>
#include <QTest>

#include "tests/suite/suite.h"

namespace tst_package_versions {

namespace {

/// What the first group of this pattern takes from a file of the source tree, or nothing.
QString found(const QString& pattern, const char* path) {
    QFile file(QStringLiteral(USAR_SOURCE_DIR "/") + path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    return QRegularExpression(pattern).match(QString::fromUtf8(file.readAll())).captured(1);
}

} // namespace

class tst_PackageVersions : public QObject {
    Q_OBJECT
private slots:
    void theChangelogBeginsWithThisVersion() {
        const QString version = found("project\\(UsarMissionControl VERSION ([0-9.]+)", "CMakeLists.txt");
        QVERIFY(!version.isEmpty());
        QCOMPARE(found("^usar-mission-control \\(([^)]+)\\)", "resources/packaging/debian/changelog"), version);
    }
    void theChangelogBeginsWithTheReleaseDate() {
        const QDate date =
            QDate::fromString(found("USAR_RELEASE_DATE ([0-9-]+)", "CMakeLists.txt"), QStringLiteral("yyyy-MM-dd"));
        QVERIFY(date.isValid());
        QCOMPARE(found(">  ([A-Z][a-z]+, [0-9]+ [A-Z][a-z]+ [0-9]+)", "resources/packaging/debian/changelog"),
                 QLocale::c().toString(date, QStringLiteral("ddd, dd MMM yyyy")));
    }
};

USAR_TEST(tst_PackageVersions)

} // namespace tst_package_versions

#include "tst_package_versions.moc"
