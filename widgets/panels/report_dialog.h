// Dialog that shows a long text to be read, copied and saved.
#pragma once

#include <QDialog>
#include <QPlainTextEdit>

namespace usar::widgets {

/// Only asks for saving; the window chooses the file. GUI thread.
class ReportDialog : public QDialog {
    Q_OBJECT
public:
    ReportDialog(const QString& title, const QString& text, QWidget* parent);

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
