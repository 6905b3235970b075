// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// A parser of the part of ECMAScript that BIFS codes. Statements are written as they are read;
// expressions are kept as a tree first, for an operator is written before its left side.
#include "bifs/script_encoder.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

#include "bifs/node_codes.h"
#include "bifs/script_syntax.h"

namespace afx::bifs {

namespace {

constexpr uint32_t kMaxDepth = 200;
constexpr uint32_t kMaxSwitchDepth = 8;  // a switch is read twice, so they must not nest for ever
constexpr unsigned kMaxIntegerBits = 31;

struct Expression {
  ScriptExpression type = ScriptExpression::identifier;
  std::string text;  ///< identifier, string or number
  std::vector<Expression> parts;
};

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '$' ||
         static_cast<unsigned char>(c) >= 0x80;
}

/// The words and signs of a text.
class Tokens {
 public:
  enum class Kind : uint8_t { end, word, number, string, sign };

  explicit Tokens(std::string_view text) : text_(text) { next(); }
  Kind kind = Kind::end;
  std::string_view token;  ///< a string without its quotes

  void next() {
    skip_space();
    const size_t begin = at_;
    if (at_ >= text_.size()) {
      kind = Kind::end;
      token = {};
    } else if (is_letter(text_[at_])) {
      while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
      set(Kind::word, begin);
    } else if (is_digit(text_[at_])) {
      take_number();
      set(Kind::number, begin);
    } else if (text_[at_] == '"' || text_[at_] == '\'') {
      take_string();
    } else {
      at_ += sign_length();
      set(Kind::sign, begin);
    }
  }

  [[nodiscard]] bool is(std::string_view text) const {
    return token == text && (kind == Kind::sign || kind == Kind::word);
  }

  [[nodiscard]] Place place() const {
    const std::string_view before = text_.substr(0, at_ - std::min(at_, token.size()));
    const auto line = static_cast<uint32_t>(std::count(before.begin(), before.end(), '\n') + 1);
    const size_t last = before.rfind('\n');
    const size_t column = before.size() - (last == std::string_view::npos ? 0 : last + 1) + 1;
    return Place::at_line(line, static_cast<uint32_t>(column));
  }

 private:
  void set(Kind found, size_t begin) {
    kind = found;
    token = text_.substr(begin, at_ - begin);
  }

  void skip_space() {
    while (at_ < text_.size()) {
      const std::string_view rest = text_.substr(at_);
      if (rest[0] == ' ' || rest[0] == '\t' || rest[0] == '\n' || rest[0] == '\r') {
        ++at_;
      } else if (rest.starts_with("//")) {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else if (rest.starts_with("/*")) {
        const size_t end = text_.find("*/", at_ + 2);
        at_ = end == std::string_view::npos ? text_.size() : end + 2;
      } else {
        return;
      }
    }
  }

  void take_number() {
    const bool hexadecimal = text_.substr(at_).starts_with("0x");
    while (at_ < text_.size()) {
      const char c = text_[at_];
      const char before = at_ > 0 ? text_[at_ - 1] : ' ';
      const bool exponent_sign = (c == '-' || c == '+') && !hexadecimal && (before | 32) == 'e';
      if (!is_digit(c) && !is_letter(c) && c != '.' && !exponent_sign) return;
      ++at_;
    }
  }

  void take_string() {
    const char quote = text_[at_];
    size_t end = at_ + 1;
    while (end < text_.size() && text_[end] != quote) end += text_[end] == '\\' ? 2 : 1;
    end = std::min(end, text_.size());
    kind = end < text_.size() ? Kind::string : Kind::end;  // not closed: the text ends
    token = text_.substr(at_ + 1, end - at_ - 1);
    at_ = std::min(end + 1, text_.size());
  }

  [[nodiscard]] size_t sign_length() const {
    size_t longest = 1;
    const std::string_view rest = text_.substr(at_);
    for (const ScriptOperator& op : script_operators())
      if (rest.starts_with(op.text)) longest = std::max(longest, op.text.size());
    if (rest.starts_with("++") || rest.starts_with("--")) longest = std::max(longest, size_t{2});
    return longest;
  }

  std::string_view text_;
  size_t at_ = 0;
};

}  // namespace

class ScriptEncoder {
 public:
  ScriptEncoder(std::string_view text, std::vector<std::string> identifiers, const ScriptBits& put)
      : in_(text), identifiers_(std::move(identifiers)), put_(put) {}

  Status write() {
    while (ok() && in_.kind != Tokens::Kind::end) {
      put(1, 1);  // hasFunction
      expect("function");
      identifier(word());
      names("(", ")");
      block();
    }
    put(0, 1);
    if (error_) return *error_;
    return {};
  }

 private:
  class Depth {
   public:
    explicit Depth(ScriptEncoder& encoder) : encoder_(encoder) {
      if (++encoder.depth_ > kMaxDepth) encoder.fail("less nesting");
    }
    ~Depth() { --encoder_.depth_; }
    Depth(const Depth&) = delete;
    Depth& operator=(const Depth&) = delete;

   private:
    ScriptEncoder& encoder_;
  };

  [[nodiscard]] bool ok() const { return !error_; }
  void fail(const std::string& expected) {
    if (error_) return;
    const std::string found = in_.kind == Tokens::Kind::end
                                  ? "the end"
                                  : "'" + std::string(in_.token.substr(0, 40)) + "'";
    error_ = Error{Errc::unsupported,
                   {},
                   "line " + to_string(in_.place()) + " of the script: found " + found +
                       " [expected " + expected + "]"};
  }
  void put(uint64_t value, unsigned bits) {
    if (ok() && !silent_) put_(value, bits);
  }
  bool accept(std::string_view text) {
    if (!ok() || !in_.is(text)) return false;
    in_.next();
    return true;
  }
  void expect(std::string_view text) {
    if (!accept(text)) fail("'" + std::string(text) + "'");
  }
  std::string word() {
    if (in_.kind != Tokens::Kind::word) return fail("a name"), std::string();
    std::string found(in_.token);
    in_.next();
    return found;
  }

  void put_text(std::string_view text) {
    for (const char c : text) put(static_cast<unsigned char>(c), 8);
    put(0, 8);
  }
  void identifier(const std::string& name) {
    const auto found = std::find(identifiers_.begin(), identifiers_.end(), name);
    put(found != identifiers_.end() ? 1 : 0, 1);
    if (found != identifiers_.end())
      return put(static_cast<uint64_t>(found - identifiers_.begin()),
                 bits_for(identifiers_.size() - 1));
    put_text(name);
    identifiers_.push_back(name);
  }
  /// Names between commas, up to a sign.
  void names(std::string_view begin, std::string_view end) {
    if (!begin.empty()) expect(begin);
    while (ok() && !in_.is(end)) {
      put(1, 1);
      identifier(word());
      if (!accept(",")) break;
    }
    put(0, 1);
    if (!begin.empty()) expect(end);
  }

  void block() {
    const bool is_compound = accept("{");
    put(is_compound ? 1 : 0, 1);
    if (!is_compound) return statement();
    while (ok() && !in_.is("}")) {
      put(1, 1);
      statement();
    }
    put(0, 1);
    expect("}");
  }

  void put_statement(ScriptStatement type) { put(static_cast<unsigned>(type), 3); }

  void statement() {
    const Depth depth(*this);
    if (!ok()) return;
    if (accept("if")) return if_statement();
    if (accept("for")) return for_statement();
    if (accept("while")) {
      put_statement(ScriptStatement::while_loop);
      bracketed_compound();
      return block();
    }
    if (accept("switch")) return switch_statement();
    if (accept("return")) {
      put_statement(ScriptStatement::return_value);
      const bool has_value = !in_.is(";") && !in_.is("}");
      put(has_value ? 1 : 0, 1);
      if (has_value) write_compound(compound());
    } else if (accept("break")) {
      put_statement(ScriptStatement::break_loop);
    } else if (accept("continue")) {
      put_statement(ScriptStatement::continue_loop);
    } else {
      put_statement(ScriptStatement::compound);
      simple_compound();
    }
    if (!accept(";") && !in_.is("}")) fail("';'");
  }

  /// An expression list, or `var a, b`.
  void simple_compound() {
    if (!accept("var")) return write_compound(compound());
    put(static_cast<unsigned>(ScriptExpression::variables), 6);
    names("", ";");
    put(0, 1);  // hasExpression
  }

  void bracketed_compound() {
    expect("(");
    write_compound(compound());
    expect(")");
  }

  void if_statement() {
    put_statement(ScriptStatement::if_else);
    bracketed_compound();
    block();
    const bool has_else = accept("else");
    put(has_else ? 1 : 0, 1);
    if (has_else) block();
  }

  void for_statement() {
    put_statement(ScriptStatement::for_loop);
    expect("(");
    for (const std::string_view end : {";", ";", ")"}) {
      const bool present = !in_.is(end);
      put(present ? 1 : 0, 1);
      if (present) simple_compound();
      expect(end);
    }
    block();
  }

  void switch_statement() {
    if (++switch_depth_ > kMaxSwitchDepth) return fail("less nesting");
    put_statement(ScriptStatement::switch_case);
    bracketed_compound();
    expect("{");
    // The width of the case values comes first: the cases are read once for it, without writing.
    const Tokens begin = in_;
    const size_t known = identifiers_.size();
    const bool was_silent = std::exchange(silent_, true);
    const uint32_t greatest = cases(0);
    silent_ = was_silent;
    identifiers_.resize(known);
    in_ = begin;
    // One bit more than the greatest needs: so the peer does.
    const unsigned bits = bits_for(greatest) + 1;
    put(bits, 5);
    cases(bits);
    --switch_depth_;
  }

  uint32_t cases(unsigned bits) {
    uint32_t greatest = 0;
    bool more = true;
    while (ok() && more) {
      expect("case");
      const std::optional<uint32_t> value = integer(in_.token);
      if (!value || in_.kind != Tokens::Kind::number) fail("a number from 0");
      in_.next();
      expect(":");
      greatest = std::max(greatest, value.value_or(0));
      put(value.value_or(0), bits);
      case_block();
      more = in_.is("case");
      put(more ? 1 : 0, 1);
    }
    const bool has_default = accept("default");
    put(has_default ? 1 : 0, 1);
    if (has_default) {
      expect(":");
      case_block();
    }
    expect("}");
    return greatest;
  }

  /// The statements of a case are one block, in braces or not.
  void case_block() {
    if (in_.is("{")) return block();
    put(1, 1);  // isCompound
    while (ok() && !in_.is("case") && !in_.is("default") && !in_.is("}")) {
      put(1, 1);
      statement();
    }
    put(0, 1);
  }

  std::vector<Expression> compound() {
    std::vector<Expression> list;
    do {
      list.push_back(assignment());
    } while (accept(","));
    return list;
  }

  static const ScriptOperator* find_operator(const Tokens& in, size_t& number) {
    if (in.kind != Tokens::Kind::sign) return nullptr;
    for (number = 0; number < script_operators().size(); ++number)
      if (script_operators()[number].text == in.token) return &script_operators()[number];
    return nullptr;
  }
  static Expression make(ScriptExpression type, std::vector<Expression> parts,
                         std::string text = {}) {
    return {type, std::move(text), std::move(parts)};
  }
  static Expression pair(size_t op, Expression left, Expression right) {
    Expression both;
    both.type =
        static_cast<ScriptExpression>(static_cast<size_t>(ScriptExpression::first_binary) + op);
    both.parts.push_back(std::move(left));
    both.parts.push_back(std::move(right));
    return both;
  }

  Expression assignment() {
    const Depth depth(*this);
    if (!ok()) return {};
    Expression left = conditional();
    size_t number = 0;
    const ScriptOperator* op = find_operator(in_, number);
    if (op == nullptr || op->binding != kBindAssignment) return left;
    in_.next();
    return pair(number, std::move(left), assignment());
  }

  Expression conditional() {
    Expression condition = binary(kBindOr);
    if (!accept("?")) return condition;
    Expression all = make(ScriptExpression::conditional, {});
    all.parts.push_back(std::move(condition));
    all.parts.push_back(assignment());
    expect(":");
    all.parts.push_back(assignment());
    return all;
  }

  Expression binary(int wanted) {
    Expression left = unary();
    size_t number = 0;
    const ScriptOperator* op = find_operator(in_, number);
    while (ok() && op != nullptr && op->binding >= wanted) {
      in_.next();
      left = pair(number, std::move(left), binary(op->binding + 1));
      op = find_operator(in_, number);
    }
    return left;
  }

  Expression unary() {
    const Depth depth(*this);
    constexpr std::pair<std::string_view, ScriptExpression> kSigns[] = {
        {"-", ScriptExpression::negate},
        {"!", ScriptExpression::logical_not},
        {"~", ScriptExpression::bit_not},
        {"++", ScriptExpression::pre_increment},
        {"--", ScriptExpression::pre_decrement}};
    if (!ok()) return {};
    for (const auto& [sign, type] : kSigns) {
      if (!accept(sign)) continue;
      Expression all = make(type, {});
      all.parts.push_back(unary());
      return all;
    }
    Expression inner = member();
    const bool up = accept("++");
    if (!up && !accept("--")) return inner;
    Expression all =
        make(up ? ScriptExpression::post_increment : ScriptExpression::post_decrement, {});
    all.parts.push_back(std::move(inner));
    return all;
  }

  Expression member() {
    Expression left = primary();
    while (ok()) {
      Expression all;
      all.parts.push_back(std::move(left));
      if (accept(".")) {
        all.type = ScriptExpression::member;
        all.text = word();
        if (in_.is("(")) {
          all.type = ScriptExpression::member_call;
          parameters(all);
        }
      } else if (accept("[")) {
        all.type = ScriptExpression::element;
        for (Expression& part : compound()) all.parts.push_back(std::move(part));
        expect("]");
      } else {
        return std::move(all.parts[0]);
      }
      left = std::move(all);
    }
    return left;
  }

  void parameters(Expression& call) {
    expect("(");
    while (ok() && !in_.is(")")) {
      call.parts.push_back(assignment());
      if (!accept(",")) break;
    }
    expect(")");
  }

  Expression primary() {
    Expression found;
    if (in_.kind == Tokens::Kind::string && in_.token.find('\0') != std::string_view::npos)
      fail("a string without zero bytes, at which its coded form ends");
    if (in_.kind == Tokens::Kind::string || in_.kind == Tokens::Kind::number) {
      found.type =
          in_.kind == Tokens::Kind::string ? ScriptExpression::string : ScriptExpression::number;
      found.text = std::string(in_.token);
      in_.next();
      return found;
    }
    if (accept("(")) {
      found.type = ScriptExpression::parentheses;
      found.parts = compound();
      expect(")");
      return found;
    }
    if (in_.is("function") || in_.is("var")) return fail("an expression"), found;
    const bool create = accept("new");
    found.text = word();
    if (!create && (found.text == "true" || found.text == "false")) {
      found.type = ScriptExpression::boolean;
    } else if (create || in_.is("(")) {
      found.type = create ? ScriptExpression::create : ScriptExpression::call;
      parameters(found);
    }
    return found;
  }

  void write_compound(const std::vector<Expression>& list) {
    for (size_t i = 0; i < list.size(); ++i) {
      if (i > 0) put(1, 1);
      write(list[i]);
    }
    put(0, 1);
  }

  void write(const Expression& e) {
    put(static_cast<unsigned>(e.type), 6);
    switch (e.type) {
      case ScriptExpression::parentheses:
        return write_compound(e.parts);
      case ScriptExpression::string:
        return put_text(e.text);
      case ScriptExpression::number:
        return write_number(e.text);
      case ScriptExpression::identifier:
        return identifier(e.text);
      case ScriptExpression::boolean:
        return put(e.text == "true" ? 1 : 0, 1);
      case ScriptExpression::call:
      case ScriptExpression::create:
        identifier(e.text);
        return write_parameters(e, 0);
      case ScriptExpression::member:
        write(e.parts[0]);
        return identifier(e.text);
      case ScriptExpression::member_call:
        write(e.parts[0]);
        identifier(e.text);
        return write_parameters(e, 1);
      case ScriptExpression::element:
        write(e.parts[0]);
        return write_compound({e.parts.begin() + 1, e.parts.end()});
      default:
        for (const Expression& part : e.parts) write(part);
    }
  }

  void write_parameters(const Expression& e, size_t first) {
    for (size_t i = first; i < e.parts.size(); ++i) {
      put(1, 1);
      write(e.parts[i]);
    }
    put(0, 1);
  }

  static std::optional<uint32_t> integer(std::string_view text) {
    const bool hexadecimal = text.starts_with("0x") || text.starts_with("0X");
    if (hexadecimal) text.remove_prefix(2);
    uint32_t value = 0;
    const auto [end, failure] =
        std::from_chars(text.data(), text.data() + text.size(), value, hexadecimal ? 16 : 10);
    const bool whole = failure == std::errc{} && end == text.data() + text.size();
    return whole && bits_for(value) <= kMaxIntegerBits ? std::optional(value) : std::nullopt;
  }

  void write_number(std::string_view text) {
    const std::optional<uint32_t> value = integer(text);
    put(value ? 1 : 0, 1);
    if (value) {
      put(bits_for(*value), 5);
      return put(*value, bits_for(*value));
    }
    for (char c : text) {
      if (c == '+') continue;
      if (c == 'e') c = 'E';
      const size_t code = kNumberCharacters.find(c);
      if (code == std::string_view::npos) return fail("a decimal number before");
      put(code, 4);
    }
    put(kNumberEnd, 4);
  }

  Tokens in_;
  std::vector<std::string> identifiers_;
  const ScriptBits& put_;
  std::optional<Error> error_;
  uint32_t depth_ = 0;
  uint32_t switch_depth_ = 0;
  bool silent_ = false;
};

Status encode_script(std::string_view text, std::vector<std::string> identifiers,
                     const ScriptBits& put) {
  constexpr std::string_view kPrefixes[] = {kScriptPrefix, "ecmascript:", "vrmlscript:"};
  bool is_inline = text.empty();
  for (const std::string_view prefix : kPrefixes) {
    if (!text.starts_with(prefix)) continue;
    text.remove_prefix(prefix.size());
    is_inline = true;
    break;
  }
  if (!is_inline)
    return Error{Errc::unsupported,
                 {},
                 "a script that is not inline [expected text that begins with javascript:]"};
  return ScriptEncoder(text, std::move(identifiers), put).write();
}

}  // namespace afx::bifs
