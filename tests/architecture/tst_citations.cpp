// Comments cite pages and their sections ("protocol.md 4.5"), and pages cite files of the tree: each must be there.
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTest>

#include "tests/suite/suite.h"

namespace tst_citations {

namespace {

const QString root = USAR_SOURCE_DIR;

QString readAll(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

struct Citation {
    QString file; ///< that cites, from the root
    int line = 0;
    QString page;
    QString section; ///< "4.5"; empty: the page as a whole
};

/// In C++ comments and texts, and in robot and world files.
std::vector<Citation> citationsIn(const QString& file, const QString& text) {
    static const QRegularExpression pattern(R"(\b([a-z][a-z-]*\.md)\b(?:,? (?:section )?(\d+(?:\.\d+)?))?)");
    std::vector<Citation> citations;
    const QStringList lines = text.split('\n');
    for (int i = 0; i < lines.size(); ++i) {
        auto found = pattern.globalMatch(lines[i]);
        while (found.hasNext()) {
            const auto match = found.next();
            citations.push_back({file, i + 1, match.captured(1), match.captured(2)});
        }
    }
    return citations;
}

std::vector<Citation> allCitations() {
    std::vector<Citation> all;
    for (const QString folder : {"app", "core", "widgets", "robots", "resources/robots", "resources/worlds"}) {
        QDirIterator it(root + '/' + folder, {"*.h", "*.cpp", "*.sdf", "*.lap"}, QDir::Files,
                        QDirIterator::Subdirectories);
        while (it.hasNext()) {
            const QString path = it.next();
            const auto some = citationsIn(QDir(root).relativeFilePath(path), readAll(path));
            all.insert(all.end(), some.begin(), some.end());
        }
    }
    return all;
}

/// Headings "## 4. Info messages" and "### 4.5 SEN: sensors" have the sections 4 and 4.5.
bool hasSection(const QString& page_text, const QString& section) {
    const QRegularExpression heading("^#+ " + QRegularExpression::escape(section) + R"(\.? )",
                                     QRegularExpression::MultilineOption);
    return heading.match(page_text).hasMatch();
}

/// What is wrong with it, or nothing. Pages are in resources/docs, or beside what cites them.
QString complaint(const Citation& citation) {
    const QString where = QString("%1:%2: ").arg(citation.file).arg(citation.line);
    const QString beside = root + '/' + QFileInfo(citation.file).path() + '/' + citation.page;
    const QString in_docs = root + "/resources/docs/" + citation.page;
    const QString path = QFile::exists(in_docs) ? in_docs : beside;
    if (!QFile::exists(path))
        return where + citation.page + " is not in resources/docs";
    if (!citation.section.isEmpty() && !hasSection(readAll(path), citation.section))
        return where + citation.page + " has no section " + citation.section;
    return {};
}

/// The paths of files in a page, as `core/base/text.h`. NAME stands for any word and is not looked for.
QStringList pathsIn(const QString& page_text) {
    static const QRegularExpression pattern(R"(`((?:app|core|widgets|robots|resources|tests)/[\w/.-]+\.\w+)`)");
    QStringList paths;
    auto found = pattern.globalMatch(page_text);
    while (found.hasNext())
        if (const QString path = found.next().captured(1); !path.contains("NAME"))
            paths << path;
    return paths;
}

} // namespace

class tst_Citations : public QObject {
    Q_OBJECT
private slots:
    void eachPageAndSectionIsThere();
    void eachFileThatAPageNamesIsThere();
    void theTestItselfSeesWhatIsMissing();
};

void tst_Citations::eachPageAndSectionIsThere() {
    const auto citations = allCitations();
    QVERIFY(citations.size() > 80);
    QStringList complaints;
    for (const Citation& citation : citations)
        if (const QString text = complaint(citation); !text.isEmpty())
            complaints << text;
    QVERIFY2(complaints.isEmpty(), qPrintable(complaints.join('\n')));
}

void tst_Citations::eachFileThatAPageNamesIsThere() {
    QStringList missing;
    qsizetype named = 0;
    QDirIterator it(root + "/resources/docs", {"*.md"}, QDir::Files);
    while (it.hasNext()) {
        const QString page = it.next();
        const QStringList paths = pathsIn(readAll(page));
        named += paths.size();
        for (const QString& path : paths)
            if (!QFile::exists(root + '/' + path))
                missing << QFileInfo(page).fileName() + " names " + path;
    }
    QVERIFY(named > 300);
    QVERIFY2(missing.isEmpty(), qPrintable(missing.join('\n')));
}

void tst_Citations::theTestItselfSeesWhatIsMissing() {
    QCOMPARE(pathsIn("see `core/base/text.h`, `resources/robots/NAME.sdf` and `text.h`"),
             QStringList{"core/base/text.h"});
    const auto found = citationsIn("core/a.h", "// (protocol.md 4.5, robots-and-worlds.md, section 5)\n// nowhere.md");
    QCOMPARE(found.size(), std::size_t(3));
    QCOMPARE(found[0].section, QString("4.5"));
    QCOMPARE(found[1].section, QString("5"));
    QVERIFY(complaint(found[0]).isEmpty() && complaint(found[1]).isEmpty());
    QVERIFY(complaint(found[2]).contains("nowhere.md is not"));
    QVERIFY(complaint({"core/a.h", 1, "protocol.md", "4.55"}).contains("no section"));
}

USAR_TEST(tst_Citations)

} // namespace tst_citations

#include "tst_citations.moc"
