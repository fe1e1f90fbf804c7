#include "widgets/panels/dialogs.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QPushButton>
#include <QRegularExpression>

#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

QString withSuffix(const QString& path, const QString& suffix) {
    return path.isEmpty() || !QFileInfo(path).suffix().isEmpty() ? path : path + suffix;
}

QString askWhereToSave(QWidget* parent, const QString& title, const QString& proposal, const QString& filters) {
    QString chosen = filters.section(QStringLiteral(";;"), 0, 0);
    const QString path = QFileDialog::getSaveFileName(parent, title, proposal, filters, &chosen);
    return withSuffix(path, QRegularExpression(QStringLiteral("\\.\\w+")).match(chosen).captured());
}

ReportDialog::ReportDialog(const QString& title, const QString& text, QWidget* parent)
    : QDialog(parent)
    , text_(new QPlainTextEdit(text, this)) {
    setWindowTitle(title);
    text_->setReadOnly(true);
    text_->setLineWrapMode(QPlainTextEdit::NoWrap); // Keeps columns of figures aligned.
    text_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    text_->setAccessibleName(title);
    auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    auto* const copied = buttons->addButton(tr("&Copy"), QDialogButtonBox::ActionRole);
    copied->setToolTip(tr("Copies the selected text, or all of it, to the clipboard"));
    auto* const saved = buttons->addButton(tr("&Save…"), QDialogButtonBox::ActionRole);
    saved->setToolTip(tr("Saves as text, or as JSON lines for other programs"));
    connect(copied, &QPushButton::clicked, this, &ReportDialog::copy);
    connect(saved, &QPushButton::clicked, this, &ReportDialog::saveRequested);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    laidOut(new QVBoxLayout(this), gap::small, {text_, buttons})->setStretchFactor(text_, 1);
}

void ReportDialog::copy() {
    if (text_->textCursor().hasSelection())
        text_->copy();
    else
        QGuiApplication::clipboard()->setText(text());
}

} // namespace usar::widgets
