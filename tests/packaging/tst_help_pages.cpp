// The pages that the Help menu opens: all of them are there, and each link within them leads somewhere.
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>
#include <QTest>

#include "tests/suite/suite.h"

namespace tst_help_pages {

namespace {

const QString source = USAR_SOURCE_DIR;
const QString html = USAR_BINARY_DIR "/share/html";

QString readAll(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

QStringList filesIn(const QString& folder, const QString& pattern) {
    QStringList files;
    QDirIterator it(folder, {pattern}, QDir::Files, QDirIterator::Subdirectories);
    while (it.hasNext())
        files << QDir(folder).relativeFilePath(it.next());
    files.sort();
    return files;
}

/// What is wrong with this link of the page, or nothing.
QString complaint(const QString& page, const QString& link) {
    if (link.contains("://") || link.startsWith("mailto:"))
        return {};
    const QString path = link.section('#', 0, 0), anchor = link.section('#', 1);
    const QString target = path.isEmpty() ? page : QDir::cleanPath(QFileInfo(page).path() + '/' + path);
    if (!QFileInfo::exists(target))
        return target + " is not there";
    if (!anchor.isEmpty() && !readAll(target).contains("id=\"" + anchor + '"'))
        return target + " has no #" + anchor;
    return {};
}

} // namespace

class tst_HelpPages : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        if (!QFileInfo::exists(html + "/README.html"))
            QSKIP("This build has no Markdown reader (cmark-gfm).");
    }

    void everyPageIsThere_data() {
        QTest::addColumn<QString>("page");
        for (const QString folder :
             {"resources/docs", "resources/robots", "resources/samples", "resources/worlds", "robots/sample"})
            for (const QString& file : filesIn(source + '/' + folder, "*.md"))
                QTest::newRow(qPrintable(folder + '/' + file)) << folder + '/' + file;
        QTest::newRow("README.md") << "README.md";
    }
    void everyPageIsThere() {
        QFETCH(QString, page);
        const QString text = readAll(html + '/' + page.replace(QRegularExpression("\\.md$"), ".html"));
        QVERIFY2(text.contains("<h1 id="), "Add it to help_pages in resources/packaging/CMakeLists.txt");
        QVERIFY(text.contains("<title>"));
    }

    void everyLinkLeadsSomewhere_data() {
        QTest::addColumn<QString>("page");
        for (const QString& page : filesIn(html, "*.html"))
            QTest::newRow(qPrintable(page)) << page;
    }
    void everyLinkLeadsSomewhere() {
        QFETCH(const QString, page);
        static const QRegularExpression pattern("(?:href|src)=\"([^\"]+)\"");
        const QString path = html + '/' + page;
        QStringList wrong;
        int links = 0;
        for (auto found = pattern.globalMatch(readAll(path)); found.hasNext(); ++links)
            if (const QString words = complaint(path, found.next().captured(1)); !words.isEmpty())
                wrong << words;
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
        QVERIFY(links >= 4); // The style and the three of the head.
    }

    void theTestItselfSeesWhatIsMissing() {
        const QString page = html + "/README.html";
        QVERIFY(complaint(page, "resources/docs/manual.html").isEmpty());
        QVERIFY(complaint(page, "nowhere.html").contains("not there"));
        QVERIFY(complaint(page, "resources/docs/manual.html#nothing-of-this-name").contains("has no"));
        QVERIFY(complaint(page, "https://example.org/x").isEmpty());
    }
};

USAR_TEST(tst_HelpPages)

} // namespace tst_help_pages

#include "tst_help_pages.moc"
