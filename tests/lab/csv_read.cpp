/// CSV read back: quotes, line ends, rows cut short; summary rows read as they were written.
#include "lab/csv_read.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "lab/options.hpp"
#include "lab/record.hpp"
#include "lab/table.hpp"

namespace mpm {
namespace {

using Words = std::vector<std::string>;

TEST(ReadCsv, GivesFieldsByColumn) {
    const CsvTable table = parse_csv("t,v\n0,1.5\n1,nan\n", "a");
    ASSERT_EQ(table.rows.size(), 2u);
    EXPECT_EQ(table.text(1, "t"), "1");
    EXPECT_EQ(table.number(0, "v"), 1.5);
    EXPECT_TRUE(std::isnan(table.number(1, "v")));
    EXPECT_TRUE(table.has("v"));
    EXPECT_FALSE(table.has("w"));
    EXPECT_THROW(table.text(0, "w"), std::out_of_range);
    EXPECT_THROW(table.text(2, "t"), std::out_of_range);
}
TEST(ReadCsv, ReadsQuotedFields) {
    EXPECT_EQ(parse_csv("a,b\n\"x, y\",\"say \"\"hi\"\"\nthere\"\n", "a").rows[0], (Words{"x, y", "say \"hi\"\nthere"}));
    EXPECT_EQ(parse_csv("a,b\n\"\",\n", "a").rows[0], (Words{"", ""}));
}
TEST(ReadCsv, ReadsBackWhatWasQuoted) {
    for (const std::string text : {"", "plain", "a,b", "\"", "\"\"", "line\nline", "cr\r", ",", "\",\"\n"})
        EXPECT_EQ(parse_csv("a,b\n" + csv_field(text) + ",x\n", "a").rows[0], (Words{text, "x"})) << text;
}
TEST(ReadCsv, TakesBothLineEnds) { EXPECT_EQ(parse_csv("a,b\r\n1,2\r\n", "a").rows[0], (Words{"1", "2"})); }
TEST(ReadCsv, LeavesOutARowThatIsCut) {
    EXPECT_EQ(parse_csv("a,b\n1,2\n3,", "a").rows.size(), 1u);
    EXPECT_EQ(parse_csv("a,b\n1,2\n3,\"open\n", "a").rows.size(), 1u);
    EXPECT_TRUE(parse_csv("", "a").columns.empty());
}
TEST(ReadCsv, NamesTheRowOfAnotherLength) {
    try {
        parse_csv("a,b\n1,2\n3\n", "data.csv");
        FAIL();
    } catch (const FileTrouble& trouble) {
        EXPECT_STREQ(trouble.what(), "data.csv: row 2 has 1 fields, the header 2");
    }
}
TEST(ReadCsv, SaysWhatCannotBeRead) {
    EXPECT_THROW(read_csv("/no/such.csv"), FileTrouble);
    EXPECT_THROW(read_csv("/tmp"), FileTrouble);
}

TEST(SummaryRow, ReadsBackAsItWasWritten) {
    SummaryRow row;
    row.program = "usl_bar";
    row.options = "cells=25,50;label=\"a b\"";
    row.cells = 25;
    row.h = 1.0 / 3;
    row.steps = 123456789012;
    row.error_name = "frequency";
    row.error = std::nan("");
    row.wall_s = 1e-300;
    row.verdict = "unstable:energy-growth";
    row.t_fail = 0.1 + 0.2;
    row.reason = "energy grew, twice";
    EXPECT_EQ(summary_fields(summary_row(summary_fields(row))), summary_fields(row));
}
TEST(SummaryRow, RefusesWhatIsNotANumber) {
    Words fields = summary_fields({});
    fields[7] = "many";
    try {
        summary_row(fields);
        FAIL();
    } catch (const std::invalid_argument& bad) {
        EXPECT_STREQ(bad.what(), "column cells: not a number: many");
    }
    EXPECT_THROW(summary_row({"usl_bar"}), std::invalid_argument);
}

}  // namespace
}  // namespace mpm
