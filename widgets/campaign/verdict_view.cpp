#include "widgets/campaign/verdict_view.h"

#include <QTextDocument>

#include "widgets/style/form_parts.h"
#include "widgets/style/scroll_box.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

/// Every word has a shape besides its color.
StateShape shapeOf(const QString& word) {
    if (word == "better")
        return StateShape::Good;
    if (word == "worse")
        return StateShape::Bad;
    return word == "undecided" ? StateShape::Waiting : StateShape::Busy;
}

QString markOf(const QString& word) {
    switch (shapeOf(word)) {
    case StateShape::Good:
        return QStringLiteral("✓");
    case StateShape::Bad:
        return QStringLiteral("✗");
    case StateShape::Waiting:
        return QStringLiteral("?");
    default:
        return QStringLiteral("=");
    }
}

QString htmlOf(const CampaignVerdict& verdict) {
    QString html = "<p><b>" + verdict.headline.toHtmlEscaped() + ".</b></p><table cellspacing='0' cellpadding='3'>";
    for (const VerdictWord& one : verdict.words)
        html += QStringLiteral("<tr><td>%1</td><td style='color:%2; white-space:nowrap'>%3 %4</td><td>%5</td></tr>")
                    .arg(one.title.toHtmlEscaped(), stateColor(shapeOf(one.word)).name(), markOf(one.word), one.word,
                         one.detail.toHtmlEscaped());
    html += "</table>";
    for (const QString& note : verdict.notes)
        html += QStringLiteral("<p style='color:%1'>%2</p>").arg(tokens().text_muted.name(), note.toHtmlEscaped());
    return html;
}

} // namespace

VerdictView::VerdictView(QWidget* parent) : QWidget(parent) {
    text_->setTextFormat(Qt::RichText);
    text_->setWordWrap(true);
    text_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    named(text_, tr("Verdict"), {});
    auto* const inside = new QWidget;
    laidOut(new QVBoxLayout(inside), {}, 0, {text_})->addStretch(1);
    scroll_ = new ScrollBox(inside);
    nothing_ = new EmptyState(scroll_);
    auto* const row = laidOut(new QHBoxLayout, gap::small, {report_});
    row->addStretch(1);
    auto* const column = laidOut(new QVBoxLayout(this), {gap::small, gap::tiny, gap::small, gap::small}, gap::tiny);
    column->addWidget(scroll_, 1);
    column->addLayout(row);
    onThemeChange(this, [this] { write(); });
    setVerdicts({}, tr("Which variant is better is said here when runs of two variants have ended."));
}

void VerdictView::setVerdicts(const std::vector<CampaignVerdict>& verdicts, const QString& instead) {
    verdicts_ = verdicts;
    nothing_->setText(tr("No verdict yet"), instead);
    nothing_->setVisible(verdicts.empty());
    write();
}

void VerdictView::setAction(QAction* report) {
    followAction(report_, report);
}

QString VerdictView::text() const {
    QTextDocument document;
    document.setHtml(text_->text());
    return document.toPlainText();
}

void VerdictView::write() {
    QString html;
    for (const CampaignVerdict& verdict : verdicts_)
        html += htmlOf(verdict);
    text_->setText(html);
}

} // namespace usar::widgets
