// Dialogs: one that asks where to save a file, and one that shows a long text.
#pragma once

#include <QDialog>
#include <QPlainTextEdit>
#include <QWidget>

namespace usar::widgets {

/// Returns `path` with `suffix` (".png") added if it has none; an empty path stays empty.
QString withSuffix(const QString& path, const QString& suffix);

/// Lets the user choose a file; empty if the user cancels. `proposal`: name or path that is offered. `filters`: as for
/// QFileDialog. A name that is typed without a suffix gets that of the chosen filter, that is, the filter's first one.
QString askWhereToSave(QWidget* parent, const QString& title, const QString& proposal, const QString& filters);

/// Only asks for saving; the window chooses the file. GUI thread.
class ReportDialog : public QDialog {
    Q_OBJECT
public:
    ReportDialog(const QString& title, const QString& text, QWidget* parent);

    /// The text that is shown, without formatting.
    QString text() const { return text_->toPlainText(); }
    QSize sizeHint() const override { return {900, 520}; }

signals:
    /// The user wants to save text().
    void saveRequested();

private:
    void copy();

    QPlainTextEdit* text_;
};

} // namespace usar::widgets
