// Nothing in the window may wait for an answer: the stop must be within reach while a robot moves.
#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTest>

#include "tests/suite/suite.h"

namespace tst_no_modal {

namespace {

/// Sentences such as "app/desks/file_desk.cpp:12: box.exec()" about what makes a dialog modal below these folders.
QStringList modalDialogsBelow(const QStringList& folders) {
    static const QRegularExpression modal("QFileDialog::get|QInputDialog::get|QColorDialog::get|QFontDialog::get"
                                          "|QMessageBox::(question|information|warning|critical|about)\\("
                                          "|(dialog|box|question)\\w*(\\.|->)(exec|open)\\("
                                          "|setModal\\(true|WindowModal|ApplicationModal");
    QStringList found;
    for (const QString& folder : folders) {
        QDirIterator files(QStringLiteral(USAR_SOURCE_DIR "/") + folder, {"*.h", "*.cpp"}, QDir::Files,
                           QDirIterator::Subdirectories);
        while (files.hasNext()) {
            QFile file(files.next());
            if (!file.open(QIODevice::ReadOnly))
                return {"cannot read " + file.fileName()};
            const QString text = QString::fromUtf8(file.readAll());
            const auto match = modal.match(text);
            if (match.hasMatch())
                found << QString("%1:%2: %3")
                             .arg(file.fileName())
                             .arg(text.first(match.capturedStart()).count('\n') + 1)
                             .arg(match.captured());
            if (text.contains("new QMessageBox(") && !text.contains("setModal(false)"))
                found << file.fileName() + ": a message box is modal unless it is told otherwise";
        }
    }
    return found;
}

} // namespace

class tst_NoModal : public QObject {
    Q_OBJECT
private slots:
    void noDialogOfTheWindowIsModal();
};

void tst_NoModal::noDialogOfTheWindowIsModal() {
    const QStringList found = modalDialogsBelow({"app", "widgets"});
    QVERIFY2(found.isEmpty(), qPrintable(found.join('\n')));
}

USAR_TEST(tst_NoModal)

} // namespace tst_no_modal

#include "tst_no_modal.moc"
