-- The weaver: turns the chapters into one HTML page, a Pandoc filter. Run in the project's folder:
--
--   pandoc paper/*.md -f markdown-implicit_figures -t html5 --wrap=none --mathml --fail-if-warnings
--     --lua-filter paper/weave.lua --citeproc --bibliography paper/references.bib
--     --template paper/template.html -M revision=REVISION -o build/report.html
--
-- (all on one line; `-M revision=`, its `-M date=` and, for Software Heritage's identifier, `-M tree=` may be left out). With `-M draft=paper/12-x.md` the page has this
-- chapter only, numbered as in the report, and links into the others lead nowhere. It reads, besides
-- the chapters, build/data/*.csv, build/data/values.json, build/figures/*.svg, figures/*.gp,
-- figures/measured/*.csv, paper/style.css and build/math.woff2, the font of the formulas, and puts all
-- of it into the page, which then needs no other file. It keeps the colours of the code in build/colours-* and
-- the figures as they stand in the page in build/drawing-*. What the chapters may write:
--
--   # Title {#sec:x}, # Title {#sec:x .appendix}      numbered sections, lettered appendices
--   # Title {#sec:x part="Part I. Name"}              the chapter begins the part of that name
--   # Title {#sec:x .paper}, ::: {.paper}             this section's own text, or what is between the colons,
--                                                     is in the short version too; a sentence that leads to a
--                                                     chunk, the chunk and its tests are not
--   ::: {.report}, ::: {.paper-only}                  what is in the other one only
--   ::: {.live views="..." scene="..." sliders="..."} a place of the solver in the page, with `-M live=yes`;
--                                                     large="yes" for the one with everything
--   ::: {.screen}                                     what leads to it, which is not printed
--   $$ ... $$ {#eq:x paper=25 status=sign}            an equation; `paper` is its number in the paper, or
--                                                     "13, 18–20"; `status` is sign, misprint, open or fails;
--                                                     chunk="Its title" and tests="A.B, A.C" are its evidence
--   ![Caption](figures/x.svg){#fig:x fig-alt="..."}   a figure, with figures/x.gp, build/data/x.csv
--   : Caption {#tbl:x}                                below a table; {#tbl:x .cards} as below
--   ::: {#tbl:x csv="x.csv"}                          a table from build/data/x.csv, or from another folder
--                                                     that csv names; the paragraph in it is the caption;
--                                                     in figures/measured/ what all rows share ends it;
--                                                     .cards: on a phone its rows are cards; a cell of data
--                                                     may lead to a chunk and to a folded test by
--                                                     [code](<#chunk:Its title>) and [test](#test:A.B)
--   ::: {#tbl:x .equations}                           the table of the equations that have a `paper`
--   @eq:x, [@fig:x; @fig:y], @lst:chunk               references
--   ``` {.cpp #name title="..." .open}                a chunk that is not folded to its title; neither is the
--                                                     first behind a numbered equation, which it is;
--                                                     no other chunk has this title
--   \value{key}, in prose also `key`{.value}          a computed number, from build/data/values.json
--                                                     from speed.json if it rests on a time, or
--                                                     study-values.json, or evaluations.json
--   *Checked by* `Suite.Name`, ...                    the tests of what stands above, which stand folded
--                                                     below it where it names them first
--   abstract-short: ...                               the abstract of the short version
--
-- A mistake (an unknown reference, a missing file, ...) ends the run, each with the place and the
-- culprit, and nothing is written. A draft tells of the mistakes in its chapter and is written.

local utils = pandoc.utils
local here = PANDOC_SCRIPT_FILE:match("^(.*/)") or "./"
dofile(here .. "tangle.lua") -- gives the table tangle
local read = tangle.read

-- 0. Files, messages, HTML --------------------------------------------------------------------------

local chapters = {} -- { name, text }, in order
local draft -- the name of the only chapter that is woven, or nil
local only_numbered = false -- whether what is walked now is numbered, but not in the page: figures are not drawn
local mistakes = pandoc.List()

--- "chapter:line: " of the first place where `culprit` is written out, or "".
local function place(culprit)
  for _, chapter in ipairs(chapters) do
    local number = 0
    for line in (chapter.text .. "\n"):gmatch("(.-)\n") do
      number = number + 1
      local _, last = line:find(culprit, 1, true)
      if last and not line:sub(last + 1, last + 1):match("[%w_-]") then
        return chapter.name .. ":" .. number .. ": "
      end
    end
  end
  return ""
end

local function complain(culprit, message, ...)
  local mistake = place(culprit) .. string.format(message, ...)
  if not mistakes:includes(mistake) then mistakes:insert(mistake) end
end

local function stop_on_mistakes()
  if draft then
    mistakes = mistakes:filter(function(text) return text:sub(1, #draft + 1) == draft .. ":" end)
  end
  if #mistakes == 0 then return end
  io.stderr:write(table.concat(mistakes, "\n"), "\n")
  if not draft then os.exit(1) end
  mistakes = pandoc.List()
end

local function raw(html) return pandoc.RawBlock("html", html) end

local function escape(text)
  return (text:gsub("[&<>\"]", { ["&"] = "&amp;", ["<"] = "&lt;", [">"] = "&gt;", ['"'] = "&quot;" }))
end

--- Data and titles may say in Markdown how a symbol is set, but bring no HTML of their own.
local without_html = "markdown-raw_html-raw_attribute-native_spans-native_divs-bracketed_spans"

local function inlines_of(markdown)
  if markdown:match("^%w[%w ]*$") then return pandoc.Inlines(markdown) end -- words only, as most are
  local inlines = pandoc.read("x " .. markdown, without_html).blocks[1].content -- "p. 3" alone would be a list
  inlines:remove(1)
  inlines:remove(1)
  return inlines
end

--- A test's name, which a phone may break before a capital.
local function breakable(name) return (escape(name):gsub("([%l.])(%u)", "%1<wbr/>%2")) end

--- The HTML that `make` gives for this source; from build/ where that has it, as an edit of the prose
--- changes no colour and no drawing.
local function once(name, source, make)
  local file, key = "build/" .. name, utils.sha1(tostring(PANDOC_VERSION) .. source)
  local kept = read(file)
  if kept and kept:sub(1, #key) == key then return kept:sub(#key + 1) end
  local html = make()
  local out = io.open(file .. ".tmp", "wb")
  if out then
    out:write(key, html)
    if out:close() then os.rename(file .. ".tmp", file) end
  end
  return html
end

--- Bytes as base64, by which a data: URI takes least room.
local function base64(bytes) return pandoc.pipe("base64", { "-w0" }, bytes) end

--- A text as xz packs it, a quarter shorter than gzip; by one thread, so that it is the same each time.
local function packed(text) return base64(pandoc.pipe("xz", { "-9e", "-T1" }, text)) end

-- 1. Labels: what can be referred to, and what it is called -----------------------------------------

local labels = {} -- id -> { kind, number, html }: what a link to it says, where that is not its number
local in_report -- the labels of the report, if the short version is woven; it links to what it leaves out

local function link(id, html)
  local page = in_report and not labels[id] and "report.html" or ""
  return string.format('<a href="%s#%s">%s</a>', page, escape(id), html)
end
local nouns = {
  eq = { "Eq.", "Eqs." }, fig = { "Figure", "Figures" }, tbl = { "Table", "Tables" },
  sec = { "Section", "Sections" }, appendix = { "Appendix", "Appendices" }, lst = { "", "" },
}

local counts = {}

--- Gives `id` the next number of its kind, or `number` itself, and returns it.
local function define(id, kind, number)
  if labels[id] then complain("#" .. id, "duplicate id %s", id) end
  counts[kind] = (counts[kind] or 0) + 1
  labels[id] = { kind = kind, number = number or tostring(counts[kind]) }
  return labels[id].number
end

local function refers(id) return nouns[id:match("^(%l+):") or ""] ~= nil end

--- A link that says "Eq. (7)", or only "(7)" if `bare`.
local function referred(id, bare)
  local label = labels[id] or in_report and in_report[id]
  if not label then
    complain("@" .. id, "unknown reference @%s", id)
    return ""
  end
  local number = label.kind == "eq" and "(" .. label.number .. ")" or label.number
  return link(id, label.html or (bare and "" or nouns[label.kind][1] .. "\u{A0}") .. number
    .. (labels[id] and "" or " of the report"))
end

-- 2. Prose: references, computed numbers, formulas --------------------------------------------------

--- `@eq:a` and `[@eq:a; @eq:b]`; other citations are left to Pandoc.
local function resolve(cite)
  local citations = cite.citations
  if not citations:find_if(function(c) return refers(c.id) end) then return nil end
  local out, kind, alike = pandoc.List(citations[1].prefix), nil, #citations > 1
  for _, citation in ipairs(citations) do
    local label = labels[citation.id] or {}
    kind = kind or label.kind
    alike = alike and kind and label.kind == kind and not label.html
  end
  if #out > 0 then out:insert(pandoc.Space()) end
  if alike then out:insert(pandoc.Str(nouns[kind][2] .. "\u{A0}")) end
  for k, citation in ipairs(citations) do
    if k > 1 then out:insert(pandoc.Str(k == #citations and " and " or ", ")) end
    out:insert(pandoc.RawInline("html", referred(citation.id, alike)))
  end
  out:extend(citations[#citations].suffix)
  return out
end

local values

--- Each file is one flat object whose values are strings, as they are to be printed.
local function read_values(path, found)
  local text = read(path)
  if not text then complain(path, "%s is missing", path) end
  local rest = (text or "{}"):gsub('"([^"\\]*)"%s*:%s*"(.-[^\\])"', function(key, value)
    found[key] = value:gsub('\\(["\\/])', "%1")
    return ""
  end)
  if not rest:match("^%s*{[%s,]*}%s*$") then
    complain(path, "%s: not one flat object of strings", path)
  end
  return found
end

local function value(key, written)
  if not values then
    values = read_values("build/data/values.json", {})
    for _, name in ipairs { "speed", "study-values", "evaluations" } do
      local path = "build/data/" .. name .. ".json"
      if read(path) then read_values(path, values) end
    end
  end
  if not values[key] then complain(written, "unknown value %s", key) end
  return values[key] or ""
end

local mathml = dofile(here .. "mathml.lua")

--- The rule that brings the font of the formulas; a draft does without where there is none yet.
local function formula_font()
  local font = read("build/math.woff2")
  return font and string.format('@font-face { font-family: "Latin Modern Math"; '
    .. 'src: url("data:font/woff2;base64,%s") format("woff2"); }\n', base64(font)) or ""
end

-- What a symbol means is shown where the pointer rests on a formula. The table of symbols says it; a symbol
-- that stands there twice, or for one section, has more meanings than one and is left out.
local meanings -- symbol, as `symbols_in` gives it -> meaning

--- The symbols of a formula in order, each with its scripts behind it: "c_0", "T_{max}^*", "\\hat p".
local function symbols_in(tex)
  local found, seen = {}, {}
  tex = tex:gsub("\\value{[^}]*}", " "):gsub("\\text{[^}]*}", " "):gsub("\\%a+{%a+ed}", " ")
    :gsub("\\hat{(.-)}", "\\hat %1"):gsub("\\hat%s+(%a)", "\1%1"):gsub("\\mathrm{(%a+)}", "\2%1\3")
  local at = 1
  while at <= #tex do
    local base, behind = tex:match("^(\2%a+\3)()", at)
    if not base then base, behind = tex:match("^(\1?\\?%a+)()", at) end
    if base and not base:match("^\1?\\") and not base:match("^\2") then
      base = base:match("^\1?%a")
      behind = at + #base
    end
    if base then
      local scripts = {}
      for _ = 1, 2 do
        local kind, script, next_at = tex:match("^([_^])(%b{})()", behind)
        if not kind then kind, script, next_at = tex:match("^([_^])(\\%a+)()", behind) end
        if not kind then kind, script, next_at = tex:match("^([_^])([%w*])()", behind) end
        if not kind then break end
        scripts[kind], behind = script:gsub("[{}]", ""), next_at
      end
      local name = base .. (scripts._ and "_" .. scripts._ or "") .. (scripts["^"] and "^" .. scripts["^"] or "")
      if not seen[name] then table.insert(found, { name = name, base = base, sub = scripts._, sup = scripts["^"] }) end
      seen[name], at = true, behind
    else
      at = at + 1
    end
  end
  return found
end

local function plain(document)
  if type(document) == "string" then document = pandoc.read(document, "markdown") end
  local text = pandoc.write(document, "plain", { wrap_text = "none" })
  return (text:gsub("%s*$", ""):gsub("%s%s+", " "):gsub("%^%(%*%)", "*"):gsub("_%((%w+)%)", "_%1"))
end

local function read_meanings()
  meanings = {}
  local table_text
  for _, chapter in ipairs(chapters) do
    if chapter.text:find("{#tbl:nomenclature", 1, true) then table_text = chapter.text end
  end
  local times = {}
  for symbols, meaning in (table_text or ""):gmatch("\n| ([^\n]-) | ([^\n]-) |") do
    local names = {}
    for tex in symbols:gmatch("%$([^$]+)%$") do
      for one in (tex .. ","):gmatch("%s*(.-),") do
        local found = symbols_in(one)
        if #found == 1 and not one:find("[/ ]%S*$") or one:find("^\\hat %a$") then
          table.insert(names, { name = found[1].name, tex = one })
        end
      end
    end
    local parts = {} -- a meaning for each, if there are as many
    for part in (meaning:gsub(",? @%l+:[%w-]+", "") .. ";"):gmatch("%s*(.-);") do table.insert(parts, part) end
    for k, item in ipairs(names) do
      local own = #parts == #names and parts[k] or table.concat(parts, "; ")
      times[item.name] = (times[item.name] or 0) + (meaning:find("^in @sec") and 2 or 1)
      meanings[item.name] = #names <= 4 and times[item.name] == 1
        and { text = plain(own), symbol = plain("$" .. item.tex .. "$") } or nil
    end
  end
end

--- What the symbols of a formula mean; of one that is a symbol by itself, without the symbol.
local function title_of(tex)
  if not meanings then read_meanings() end
  local found, out = symbols_in(tex), {}
  for _, symbol in ipairs(found) do
    local meaning = meanings[symbol.name]
      or symbol.sup and (meanings[symbol.base .. "^" .. symbol.sup] or symbol.sup == "*" and symbol.sub and meanings[symbol.base .. "_" .. symbol.sub])
    if meaning then table.insert(out, #found == 1 and meaning.text or meaning.symbol .. " " .. meaning.text) end
  end
  return #out > 0 and table.concat(out, "; ") or nil
end

local linked_to_its_chunk -- of section 7: (key, number) -> number

--- A formula in the text that has a computed number in it leads to the chunk of that number.
local function formula(math)
  local keys = {}
  local tex = math.text:gsub("\\value{([^}]*)}", function(key)
    table.insert(keys, key)
    return "{" .. value(key, "\\value{" .. key .. "}") .. "}"
  end)
  local html = mathml(tex, math.mathtype)
  if not html then complain(math.text, "this formula cannot be written as MathML: %s", tex) end
  if #keys > 0 and (#keys > 1 or math.mathtype == "DisplayMath") then
    complain(math.text, "a formula has two computed numbers, or stands alone: it can lead to neither chunk")
  elseif #keys == 1 then
    return linked_to_its_chunk(keys[1], pandoc.RawInline("html", html or ""))
  end
  local title = html and title_of(math.text)
  if title and (math.mathtype == "DisplayMath" or #symbols_in(math.text) == 1) then
    html = string.format('<span title="%s">%s</span>', escape(title), html)
  end
  return pandoc.RawInline("html", html or "")
end

local function value_in_text(key, written)
  local text = value(key, written)
  local shown = text:find("[\\^]") and formula(pandoc.Math("InlineMath", (text:gsub("%$", ""))))
    or pandoc.Str((text:gsub("^-", "−")))
  return linked_to_its_chunk(key, shown)
end

local function code(inline)
  if inline.classes:includes("value") then
    return value_in_text(inline.text, "`" .. inline.text .. "`{.value}")
  end
  if inline.text:match("^%-%-[%w-]+$") then inline.classes:insert("one") end -- an option
  if inline.text:find("%s%-%-") then -- a command, whose options are not broken behind a hyphen
    local html = escape(inline.text):gsub("%-%-[%w-]+", '<span class="one">%0</span>')
    return pandoc.RawInline("html", "<code>" .. html .. "</code>")
  end
  return inline
end

--- Pandoc would drop all TeX outside of formulas without a word.
local function refuse_tex(element)
  if element.format ~= "html" then
    complain(element.text, "%s stands outside of a formula", element.text)
  end
end

local function raw_inline(inline)
  local key = inline.text:match("^\\value{([^}]*)}$")
  if key then return value_in_text(key, inline.text) end
  refuse_tex(inline)
end

--- A formula and the punctuation behind it stay on one line, as do a number and its unit.
local units = { ["°C"] = true, ["m/s"] = true, ms = true, ["µs"] = true, GPa = true, MPa = true, mm = true }
local function is_unit(inline)
  if inline.t ~= "Str" then return false end
  local text = inline.text
  return text:match("^%%%p*$") or units[text:match("^(.-)%p*$")]
end

local function keep_together(inlines)
  local out = pandoc.List()
  for place, inline in ipairs(inlines) do
    local before, kind = out[#out], inline.t
    if (kind == "Space" or kind == "SoftBreak") and inlines[place + 1] and is_unit(inlines[place + 1]) then
      inline = pandoc.Str("\u{a0}")
    end
    if kind == "RawInline" and (inline.text:match("^<math") or inline.text:match("^<span title"))
       and before and before.t == "Str" and before.text:match("^%($") then
      out[#out] = pandoc.RawInline("html", '<span class="one">(' .. inline.text .. "</span>")
    elseif kind == "Str" and inline.text:match("^[,.;:)?!]") and before
       and before.t == "RawInline" and (before.text:match("^<math") or before.text:match("^<span ")
         or before.text:match("^<a title[^>]*><math")) then
      out[#out] = pandoc.Span({ before, inline }, pandoc.Attr("", { "one" }))
    else
      out:insert(inline)
    end
  end
  return out
end

local prose = { Cite = resolve, Code = code, RawInline = raw_inline, RawBlock = refuse_tex,
                Math = formula, Inlines = keep_together }

local function html_of(inlines)
  local document = pandoc.Pandoc({ pandoc.Plain(inlines:walk(prose)) })
  return (pandoc.write(document, "html5", { wrap_text = "none" }))
end

-- 3. Sections: numbered headings; chapters are letters after the first appendix ---------------------

local section = { 0, 0, 0 }
local appendices = false
local chapter = 0 -- the one whose heading was numbered last

local function number_heading(heading)
  local level = heading.level
  if draft and level == 1 then
    chapter = chapter + 1
    only_numbered = chapters[chapter].name ~= draft
  end
  heading.level = level + 1 -- the page's title has the first level
  if heading.classes:includes("unnumbered") or level > #section then return heading end
  section[level] = section[level] + 1
  for k = level + 1, #section do section[k] = 0 end
  if level == 1 and heading.classes:includes("appendix") and not appendices then
    appendices, section[1] = true, 1
  end
  local parts = table.move(section, 1, level, 1, {})
  if appendices then parts[1] = string.char(("A"):byte() + parts[1] - 1) end
  local number = table.concat(parts, ".")
  if heading.identifier:match("^sec:") then
    define(heading.identifier, appendices and "appendix" or "sec", number)
  end
  heading.content:insert(1, pandoc.Span(number, pandoc.Attr("", { "no" })))
  heading.content:insert(2, pandoc.Space())
  return heading
end

--- The name of a part stands before its first chapter.
local function part_before(heading)
  local part = heading.attributes.part
  if not part then return nil end
  heading.attributes.part = nil
  return { pandoc.Div({ pandoc.Plain(part) }, pandoc.Attr("", { "part-title" })), heading }
end

--- A chapter is a section, so that the browser can lay it out and draw it without looking at the rest.
--- (In raw HTML: a Div of Pandoc's would take the heading's id from it.)
local function in_sections(blocks)
  local out, first = pandoc.List(), true
  for _, block in ipairs(blocks) do
    if block.t == "Header" and block.level == 2 then
      out:insert(raw((first and "" or "</section>") .. '<section class="chapter">'))
      first = false
    end
    out:insert(block)
  end
  if not first then out:insert(raw("</section>")) end
  return out
end

-- The short version: what the chapters mark as .paper, without chunks and their tests, numbered anew ----

local function is_chunk(block)
  return block.t == "CodeBlock" and (block.identifier ~= "" or block.attributes.file)
end

local function names_tests(block)
  local first = block.t == "Para" and block.content[1]
  return first and first.t == "Emph" and utils.stringify(first) == "Checked by"
end

--- Whether a paragraph only leads to the chunk behind it.
local function introduces(block, following)
  return block.t == "Para" and following and is_chunk(following) and utils.stringify(block):match("[:,]%s*$")
end

--- The blocks of all divisions that are for one version, in this version: each with whether it is marked.
--- A division that has another class besides stays, for the style sheet.
local function of_version(blocks, short)
  local out = {}
  local own = { paper = true, report = true, ["paper-only"] = true }
  for _, block in ipairs(blocks) do
    local classes = block.t == "Div" and block.classes or pandoc.List()
    local marked = classes:includes("paper") or classes:includes("paper-only")
    local other = classes:filter(function(class) return not own[class] end)
    if not marked and not classes:includes("report") then
      table.insert(out, { block, false })
    elseif not classes:includes(short and "report" or "paper-only") then
      local inside = #other > 0 and { pandoc.Div(block.content, pandoc.Attr(block.identifier, other)) } or block.content
      for _, part in ipairs(inside) do table.insert(out, { part, marked }) end
    end
  end
  return out
end

local function whole(blocks)
  return pandoc.List(of_version(blocks, false)):map(function(pair) return pair[1] end)
end

--- Of the chapters the sections whose headings are marked, and the marked divisions of others, under
--- their headings.
local function shortened_text(blocks)
  local out, above, marked = pandoc.List(), pandoc.List(), false
  local pairs_of = of_version(blocks, true)
  for k, pair in ipairs(pairs_of) do
    local block, following = pair[1], pairs_of[k + 1] and pairs_of[k + 1][1]
    if block.t == "Header" then
      while #above > 0 and above[#above].level >= block.level do above:remove() end
      above:insert(block)
      marked = block.classes:includes("paper")
      block.attributes.part = nil
    elseif (marked or pair[2]) and not is_chunk(block) and not names_tests(block)
        and not introduces(block, following) then
      out:extend(above)
      above = pandoc.List()
      out:insert(pandoc.walk_block(block, { Span = function(span)
        return span.classes:includes("report") and {} or nil
      end }))
    end
  end
  return out
end

-- 4. Equations: a paragraph is cut at its displayed formulas ----------------------------------------

--- From the inlines behind a formula takes `{#eq:id paper=.. status=..}`: id, the paper's numbers and what
--- became of its equations, the rest.
local function take_label(inlines)
  local text = ""
  for k, inline in ipairs(inlines) do
    if inline.t == "Math" or k > 60 then break end
    text = text .. utils.stringify(inline)
    local id, options, rest = text:match("^%s*{#(eq:[%w:_.-]+)%s*(.-)}(.*)$")
    if id then
      local remaining = pandoc.List(table.move(inlines, k + 1, #inlines, 1, {}))
      if rest ~= "" then remaining:insert(1, pandoc.Str(rest)) end
      local found = {}
      options = options:gsub("“", '"'):gsub("”", '"'):gsub('(%a+)="([^"]*)"', function(key, text)
        found[key] = text
        return ""
      end)
      for key, text in options:gmatch("(%a+)=(%S+)") do found[key] = text end
      return id, found, remaining
    end
  end
  return nil, {}, inlines
end

--- The formulas that stand beside each other in a displayed one, apart by \quad or \qquad: lines may break there.
local function side_by_side(tex)
  local parts, from, depth = pandoc.List(), 1, 0
  local deeper = { ["{"] = 1, ["}"] = -1, ["\\begin"] = 1, ["\\end"] = -1, ["\\left"] = 1, ["\\right"] = -1 }
  for at, token, behind in tex:gmatch("()([\\{}]%a*)()") do
    if (token == "\\qquad" or token == "\\quad") and depth == 0 then
      parts:insert(tex:sub(from, at - 1))
      from = behind
    end
    depth = depth + (deeper[token:match("^[{}]") or token] or 0)
  end
  parts:insert(tex:sub(from))
  return parts
end

-- What became of an equation of the paper.
local statuses = { misprint = "misprint", sign = "sign corrected", open = "left open", fails = "does not hold" }
local of_paper = pandoc.List() -- { id, number, numbers, status, chunk, tests }: equations that are the paper's

--- Adds an equation that is the paper's, by its numbers, as in "13, 18–20".
local function keep_of_paper(id, number, options)
  local status = options.status or "as printed"
  if options.status and not statuses[status] then complain("status=" .. status, "unknown status %s", status) end
  of_paper:insert({ id = id, number = number, numbers = options.paper, status = statuses[status] or status,
                    first = tonumber(options.paper:match("%d+")) or 0, titled = options.chunk,
                    tests = options.tests and pandoc.List() })
  for name in (options.tests or ""):gmatch("[%w.]+") do of_paper[#of_paper].tests:insert(name) end
end

local function equation(math, id, options)
  local paper = options.paper
  local formulas = side_by_side(math.text):map(function(tex) return pandoc.Math("DisplayMath", tex) end)
  local parts = { raw('<div class="formula">'), pandoc.Plain(formulas), raw("</div>") }
  if id then
    local number = define(id, "eq")
    if paper then keep_of_paper(id, number, options) end
    local theirs = paper and string.format(
      '<span class="paper-number" title="Equation (%s) of the paper">[%s]</span>', escape(paper), escape(paper)) or ""
    table.insert(parts, raw(string.format('<div class="number">(%s) %s</div>', number, theirs)))
  end
  return pandoc.Div(parts, pandoc.Attr(id or "", { "equation" }))
end

local spaces = { Space = true, SoftBreak = true, LineBreak = true }
local function trimmed(inlines)
  while #inlines > 0 and spaces[inlines[1].t] do inlines:remove(1) end
  while #inlines > 0 and spaces[inlines[#inlines].t] do inlines:remove() end
  return inlines
end

local function cut_at_formulas(paragraph)
  local function is_display(inline) return inline.t == "Math" and inline.mathtype == "DisplayMath" end
  if not paragraph.content:find_if(is_display) then return nil end
  local blocks, text, rest = pandoc.List(), pandoc.List(), paragraph.content
  local function flush()
    if #trimmed(text) > 0 then blocks:insert(pandoc.Para(text)) end
    text = pandoc.List()
  end
  while #rest > 0 do
    local inline, id, options = rest:remove(1), nil, nil
    if is_display(inline) then
      flush()
      id, options, rest = take_label(rest)
      blocks:insert(equation(inline, id, options))
    else
      text:insert(inline)
    end
  end
  flush()
  return blocks
end

-- 5. Figures: the drawing itself, with colours that follow the page ---------------------------------

local style = read(here .. "style.css") or ""
local drawn = {} -- { name, id, drawer } of every figure, in order

local function caption(noun, number, inlines)
  return pandoc.List({ pandoc.Strong(noun .. " " .. number .. "."), pandoc.Space() }) .. inlines
end

--- Keeps of the points between two, in hundredths, those that draw the line within twelve
--- hundredths, hardly more than the tenth that they are rounded to: the one farthest from the chord, and so on either side.
local function keep_corners(points, from, to, kept)
  local a, b = points[from], points[to]
  local dx, dy = b.x - a.x, b.y - a.y
  local square, largest, farthest = dx * dx + dy * dy, 12, nil
  for k = from + 1, to - 1 do
    local x, y = points[k].x - a.x, points[k].y - a.y
    local share = square == 0 and 0 or math.max(0, math.min(1, (x * dx + y * dy) / square))
    local distance = math.sqrt((x - share * dx) ^ 2 + (y - share * dy) ^ 2)
    if distance > largest then largest, farthest = distance, k end
  end
  if not farthest then return end
  kept[farthest] = true
  keep_corners(points, from, farthest, kept)
  keep_corners(points, farthest, to, kept)
end

--- The points of a path of lines in hundredths, each with its command, without those that are not seen.
local function corners(path)
  local points, kept, from = {}, {}, 1
  for command, x, y in path:gmatch("([ML]?)%s*(-?[%d%.]+),(-?[%d%.]+)") do
    table.insert(points, { command = command, x = math.floor(100 * x + 0.5), y = math.floor(100 * y + 0.5) })
  end
  for k, point in ipairs(points) do
    local next_one = points[k + 1]
    if point.command == "M" then from = k end
    if not next_one or next_one.command == "M" then
      kept[from], kept[k] = true, true
      keep_corners(points, from, k, kept)
    end
  end
  local out = {}
  for k, point in ipairs(points) do
    if kept[k] then table.insert(out, point) end
  end
  return out
end

--- A path of lines by the steps from corner to corner, in tenths, which are shorter and as good to the
--- eye. Between numbers stands what keeps them apart: nothing before a sign, or before a second point.
local function relative(path)
  local out, last = {}, ""
  local function add(tenths)
    local number = string.format("%.1f", tenths / 10):gsub("%.0$", ""):gsub("^(-?)0%.", "%1.")
    local apart = last == "" or number:find("^-") or number:find("^%.") and last:find(".", 1, true)
    table.insert(out, (apart and "" or " ") .. number)
    last = number
  end
  local x, y = 0, 0
  for _, point in ipairs(corners(path)) do
    if point.command == "M" then
      table.insert(out, "m")
      last = ""
    end
    local to_x, to_y = math.floor(point.x / 10 + 0.5), math.floor(point.y / 10 + 0.5)
    add(to_x - x)
    add(to_y - y)
    x, y = to_x, to_y
  end
  return table.concat(out)
end

--- Areas that follow each other with the same attributes, as one path; they must not overlap.
local function joined(svg)
  local found
  repeat
    svg, found = svg:gsub("(<path[^>]* d=')([^'Z]*)Z'/>%s*%1", "%1%2")
  until found == 0
  return svg
end

--- Marks that follow each other at one scale and in one colour, as a group of places.
local function grouped(svg)
  local mark = "<use xlink:href='(#gpPt%d+)' transform='translate%(([%d.-]+),([%d.-]+)%) scale%(([%d.]+)%)'([^>]*)/>"
  local out, at, open = {}, 1, nil
  while true do
    local first, last, name, x, y, scale, colour = svg:find(mark, at)
    if not first then break end
    local between, group = svg:sub(at, first - 1), "<g transform='scale(" .. scale .. ")'" .. colour .. ">"
    if group ~= open or between:find("%S") then
      table.insert(out, (open and "</g>" or "") .. between .. group)
      open = group
    end
    table.insert(out, ("<use xlink:href='%s' x='%.2f' y='%.2f'/>"):format(name, x / scale, y / scale))
    at = last + 1
  end
  return table.concat(out) .. (open and "</g>" or "") .. svg:sub(at)
end

--- The drawing without marks that it does not use and without spaces between its parts, its paths by
--- steps.
local function shortened(svg)
  svg = svg:gsub("<filter.-</filter>", function(filter)
    return svg:find("url(#" .. filter:match("id='([^']*)'") .. ")", 1, true) and filter or ""
  end)
  for _ = 1, 3 do -- a mark may use another
    svg = svg:gsub("<%a+[^>]*%sid='(gpPt%d+)'[^>]*/>", function(mark)
      return not svg:find("#" .. mark .. "['\"]") and "" or nil
    end)
  end
  svg = grouped(svg)
  svg = svg:gsub("translate%(([%d.-]+),([%d.-]+)%)", function(x, y) return ("translate(%.1f,%.1f)"):format(x, y) end)
  svg = svg:gsub("<polygon([^>]*)%spoints = '([^'>]*)'%s*/>", "<path%1 d='M%2Z'/>")
  return (joined(svg):gsub("%sd='(M[%d%.,%sML-]*)Z?%s*'", function(path) return " d='" .. relative(path) .. "'" end)
    :gsub('<tspan font%-family="sans%-serif" >', "<tspan>"):gsub(">%s*\n%s*<", "><")
    :gsub("<g [^>]*></g>", ""):gsub("<title>[%w_]+_plot_%d+%a?</title>", "") -- gnuplot's own name for a curve
    :gsub("(['#])gpPt(%d)", "%1p%2"):gsub("<tspan[^>]*></tspan></text>", "</text>"):gsub("'  d='", "' d='"))
end

--- A label as one text, whose colour and place the style sheet has unless it says otherwise.
local function short_label(place, size, anchor, text)
  if text:find("<text>", 1, true) then return nil end
  text = text:gsub("^<tspan>%s*([^<]*)</tspan>$", "%1")
  return '<text transform="' .. place .. '"' .. size:gsub("%s+$", "") .. (anchor == "start" and "" or ' text-anchor="' .. anchor .. '"') .. ">" .. text .. "</text>"
end

--- What most groups of a drawing have in common, which they inherit from the whole in the page.
local common = 'fill="none" stroke="currentColor" stroke-width="0.8" stroke-linecap="round" '
  .. 'stroke-linejoin="round" font-family="sans-serif" font-size="17"'

local function without_the_common(svg)
  return (svg:gsub('<g fill="none" stroke="currentColor"', "<g")
    :gsub(' stroke%-linecap="round" stroke%-linejoin="round"', ""):gsub('<g stroke%-width="0.80">', "<g>")
    :gsub("<g><path stroke='currentColor' ", "<g><path "):gsub(' font%-family="sans%-serif"', ""):gsub(' font%-size="17.00"', "")
    :gsub('<rect[^>]*fill="none"/>', "")
    :gsub('<g transform="([^"]*)" stroke="none" fill="currentColor"([^>]-)%s*text%-anchor="(%a+)"><text>(.-)</text></g>', short_label))
end

--- All that a drawing in the page depends on, besides its own file and its text.
local drawing_rules = style .. (read(PANDOC_SCRIPT_FILE) or "")

--- A figure's SVG as part of the page: ids of its own, the page's colours, a text for those who do
--- not see it. A colour #rrggbb becomes the variable --ink-rrggbb where the style sheet has one.
local function inline_svg(svg, name, alternative)
  svg = shortened(svg)
  local function colour(hex)
    hex = hex:lower()
    if hex == "000000" then return "currentColor" end
    if style:find("--ink-" .. hex, 1, true) then return "var(--ink-" .. hex .. ")" end
    return "#" .. hex
  end
  svg = svg:gsub("^.-(<svg)", "%1"):gsub("<title>[^<]*</title>%s*<desc>[^<]*</desc>", "", 1)
    :gsub("<rect[^>]*fill=[\"']#[fF]+[\"']%s*/>", "", 1)
    :gsub("rgb%(%s*(%d+),%s*(%d+),%s*(%d+)%s*%)", function(r, g, b)
      return string.format("#%02x%02x%02x", tonumber(r), tonumber(g), tonumber(b))
    end)
    :gsub("([\"'])black([\"'])", "%1#000000%2")
    :gsub("([\"'])#(%x%x%x%x%x%x)([\"'])", function(a, hex, b) return a .. colour(hex) .. b end)
    :gsub("(%sid=[\"'])", "%1" .. name .. "-"):gsub("(url%(#)", "%1" .. name .. "-")
    :gsub("(xlink:href=[\"']#)", "%1" .. name .. "-"):gsub("xlink:href=", "href="):gsub(" color=[\"']currentColor[\"']", "")
  local box = svg:match("viewBox=\"[^\"]*\"") or ""
  return (without_the_common(svg):gsub("^<svg.->", function()
    return string.format('<svg xmlns="http://www.w3.org/2000/svg" %s %s role="img" aria-label="%s">',
      box, common, escape(alternative))
  end))
end

--- The same, kept; not by the short version, which may be woven at the same time.
local function drawing(svg, name, alternative)
  local function make() return inline_svg(svg, name, alternative) end
  if in_report then return make() end
  return once("drawing-" .. name, drawing_rules .. svg .. alternative, make)
end

local function figure(image)
  local id, name = image.identifier, image.src:match("^figures/([%w_-]+)%.svg$")
  local alternative = image.attributes["fig-alt"] or ""
  if not id:match("^fig:") or not name then
    complain(image.src, "figure %s is not written as ![...](figures/name.svg){#fig:id}", image.src)
    return nil
  end
  local number = define(id, "fig")
  if alternative == "" then complain("#" .. id, "figure %s has no fig-alt text", id) end
  if only_numbered then return {} end
  local function part(path)
    local text = read(path)
    if not text then complain("#" .. id, "figure %s needs %s, which is missing", id, path) end
    return text or ""
  end
  part("figures/" .. name .. ".gp")
  local svg, data = part("build/figures/" .. name .. ".svg"), part("build/data/" .. name .. ".csv")
  table.insert(drawn, { name = name, id = id, drawer = svg:match("<desc>Produced by (.-)%s*</desc>") })
  local sources = string.format(' <span class="sources">%s '
    .. '<a href="data:application/x-xz;base64,%s" download="%s.csv.xz">data</a> %s %s</span>',
    link("script:" .. name, "script"), packed(data), name, link("command:" .. name, "command"), link("check:" .. name, "test"))
  local text = caption("Figure", number, image.caption)
  text:insert(pandoc.RawInline("html", sources))
  return { raw('<figure id="' .. escape(id) .. '">\n<div class="drawing">'),
           raw(drawing(svg, name, alternative)), raw("</div>\n<figcaption>"),
           pandoc.Plain(text), raw("</figcaption>\n</figure>") }
end

local function figure_alone(paragraph)
  local image = paragraph.content[1]
  if #paragraph.content == 1 and image.t == "Image" then return figure(image) end
end

-- 6. Tables: numbered captions, tables from CSV -----------------------------------------------------

local card_rules = pandoc.List() -- of the style sheet: where rows are cards, each value has its column's name

--- A style sheet has no formulas: a symbol stands there in the characters that it has.
local function name_columns(id, head)
  for column, name in ipairs(head) do
    local text = type(name) == "string" and name or plain(pandoc.Pandoc({ pandoc.Plain(utils.blocks_to_inlines(name)) }))
    card_rules:insert(string.format('[id="%s"] td:nth-child(%d) { --column: "%s"; }', id, column, text:gsub('[\\"<_]', "")))
  end
end

local function framed_table(content, id, text, class)
  if content.colspecs then
    local aligns = content.colspecs:map(function(spec) return spec[1] end)
    local function set_right(row) -- by a class; the style sheet has all other columns at the left
      for column, cell in ipairs(row.cells) do
        if aligns[column] == "AlignRight" then cell.classes:insert("r") end
      end
      return row
    end
    content.head.rows = content.head.rows:map(set_right)
    for _, part in ipairs(content.bodies) do part.body = pandoc.List(part.body):map(set_right) end
    content.colspecs = content.colspecs:map(function() return { "AlignDefault", nil } end)
  end
  local blocks = pandoc.List({ raw(id and string.format('<figure class="%s" id="%s">', class or "table", escape(id)) or "<figure>") })
  if id then
    blocks:extend({ raw("<figcaption>"), pandoc.Plain(caption("Table", define(id, "tbl"), text)),
                    raw("</figcaption>") })
  end
  blocks:extend({ raw('<div class="scroll">'), content, raw("</div>\n</figure>") })
  return blocks
end

--- A table of the chapter; `{#tbl:id}` ends its caption. Pandoc reads it as a word of the caption, and
--- from 3.8.2 on as the table's identifier.
local function written_table(content)
  local text, id = utils.blocks_to_inlines(content.caption.long), content.identifier
  local cards = content.classes:includes("cards")
  if id == "" then
    local last = text[#text]
    if last and last.t == "Str" and last.text == ".cards}" and text[#text - 2].t == "Str" then
      cards = true
      text:remove()
      text:remove()
      text[#text] = pandoc.Str(text[#text].text .. "}")
      last = text[#text]
    end
    id = last and last.t == "Str" and last.text:match("^{#(tbl:[%w:_.-]+)}$") or nil
    if id then text:remove() end
  end
  content.identifier = ""
  content.caption = { long = {} }
  if not cards or not id then return framed_table(content, id, trimmed(text)) end
  name_columns(id, content.head.rows[1].cells:map(function(cell) return cell.contents end))
  return framed_table(content, id, trimmed(text), "table cards")
end

--- The cells of a line of CSV; one in quotes may hold commas, and quotes written twice.
local function csv_cells(line)
  local cells, at = pandoc.List(), 1
  repeat
    local cell
    if line:sub(at, at) == '"' then
      local last = at
      repeat
        last = line:find('"', last + 1, true)
        local doubled = line:sub(last + 1, last + 1) == '"'
        if doubled then last = last + 1 end
      until not doubled
      cell, at = line:sub(at + 1, last - 1):gsub('""', '"'), last + 2
    else
      cell = line:match("^[^,]*", at)
      at = at + #cell + 1
    end
    cells:insert(cell)
  until at > #line + 1
  return cells
end

--- The table of the paper's equations is filled in when all of them are known.
local equations_table = "<!-- equations -->"

local function table_of_equations(div)
  name_columns(div.identifier, { "paper", "here", "status", "chunk", "checked by" })
  return framed_table(raw(equations_table), div.identifier, utils.blocks_to_inlines(div.content), "table cards")
end

--- What is the same in all rows of measured data is told once, behind the caption: the machine, the day.
local function take_constant_columns(head, rows)
  local told = pandoc.List()
  for column = #head, 1, -1 do
    local value = rows[1][column]
    if #rows > 1 and not rows:find_if(function(row) return row[column] ~= value end) then
      told:insert(1, head[column] .. " " .. value)
      for _, row in ipairs(rows) do row:remove(column) end
      head:remove(column)
    end
  end
  if #told == 0 then return {} end
  local text = " " .. table.concat(told, ", "):gsub("^%l", string.upper) .. "."
  return { pandoc.Str(text:gsub("%d+%-%d+%-%d+", function(day) return (day:gsub("-", "\u{2011}")) end)) } -- a day is one word
end

local led_to_evidence -- of section 8: inlines with links to chunks and tests -> inlines

local function generated_table(div)
  if div.classes:includes("equations") then return table_of_equations(div) end
  if not div.attributes.csv then return nil end
  local id, path = div.identifier, div.attributes.csv
  if only_numbered then
    define(id, "tbl")
    return {}
  end
  if not path:find("/", 1, true) then path = "build/data/" .. path end
  local text = read(path)
  if not text then
    complain("#" .. id, "table %s needs %s, which is missing", id, path)
    return {}
  end
  local rows = pandoc.List()
  for line in text:gmatch("[^\r\n]+") do rows:insert(csv_cells(line)) end
  local head, told = rows:remove(1), {}
  if path:find("measured/", 1, true) then told = take_constant_columns(head, rows) end
  local function is_numeric(column)
    return rows:find_if(function(row) return tonumber(row[column]) end)
      and not rows:find_if(function(row) return not tonumber(row[column]) and row[column] ~= "–" end)
  end
  local aligns, widths = {}, {}
  for column in ipairs(head) do
    aligns[column], widths[column] = is_numeric(column) and "AlignRight" or "AlignLeft", 0
  end
  local function inlines(cell)
    local text = (" " .. cell):gsub(" %-(%d)", " −%1"):sub(2) -- a minus, not a hyphen
    text = text:gsub("%f[%w](%d[%d.]*)e(%-?)0*(%d+)%f[^%w]", function(factor, minus, exponent) -- 2e-3 is 2 · 10^−3^
      return (factor == "1" and "" or factor .. "·") .. "10^" .. (minus == "" and "" or "−") .. exponent .. "^"
    end)
    local plainly = tonumber(cell) and not text:find("^", 1, true)
    return { pandoc.Plain(plainly and { pandoc.Str(text) } or led_to_evidence(inlines_of(text))) }
  end
  local simple = pandoc.SimpleTable({}, aligns, widths, head:map(inlines),
                                    rows:map(function(row) return row:map(inlines) end))
  local cards = div.classes:includes("cards")
  if cards then name_columns(id, head:map(function(cell) return { pandoc.Plain(inlines_of(cell)) } end)) end
  return framed_table(utils.from_simple_table(simple), id, utils.blocks_to_inlines(div.content) .. told,
                      cards and (is_numeric(1) and "table cards by-number" or "table cards"))
end

-- 7. Chunks: the program's parts, where each is told ------------------------------------------------

local pieces = pandoc.List() -- what the tangler sees, in order
local collected -- and as it collects them: name -> pieces
local chunks = {} -- name -> { name, number, title, html, file, pieces, users }; html is ⟨Title 12⟩

local function titled(chunk, title, part)
  return string.format('⟨%s <small>%s%s</small>⟩', -- a short tag, as it stands thousands of times
    title and html_of(inlines_of(title)) or escape(chunk.name), chunk.number, part and "." .. part or "")
end

--- A chunk whose later parts have titles of their own goes by its name; each part has its title.
local function collect_chunks()
  for _, chapter in ipairs(chapters) do
    pieces:extend(tangle.parse(chapter.name, chapter.text))
  end
  collected = tangle.collect(pieces)
  local first = {} -- title -> the piece that has it: a title leads to one place
  for _, piece in ipairs(pieces) do
    local other = first[piece.title or ""]
    if other then
      mistakes:insert(string.format("%s:%d: the title '%s' stands already at %s:%d", piece.source, piece.line - 1,
        piece.title, other.source, other.line - 1))
    end
    if piece.title then first[piece.title] = piece end
    local chunk = chunks[piece.id]
    if not chunk then
      chunk = { name = piece.id, number = define("lst:" .. piece.id, "lst"),
                pieces = collected[piece.id], users = {} }
      chunks[piece.id] = chunk
    end
    if piece.title and piece ~= chunk.pieces[1] then chunk.of_parts = true end
    chunk.title = chunk.title or piece.title
    chunk.file = chunk.file or piece.file
  end
  for _, chunk in pairs(chunks) do
    for part, piece in ipairs(chunk.pieces) do piece.part = part end
  end
  for place, piece in ipairs(pieces) do
    piece.place = place
    for _, line in ipairs(piece.code) do
      local _, name = tangle.reference(line)
      if name and not chunks[name] then
        complain("<<" .. name .. ">>", "missing chunk <<%s>>", name)
      elseif name then
        table.insert(chunks[name].users, piece)
      end
    end
  end
  stop_on_mistakes()
  for _, chunk in pairs(chunks) do
    chunk.html = titled(chunk, not chunk.of_parts and chunk.title)
    for part, piece in ipairs(chunk.pieces) do
      piece.html_title = chunk.of_parts and piece.title and titled(chunk, piece.title, part) or chunk.html
    end
    labels["lst:" .. chunk.name].html = chunk.html
  end
end

local function anchor(piece)
  return "lst:" .. piece.id .. (piece.part > 1 and ":" .. piece.part or "")
end

--- The chunks that write values, by the words in their lines such as v["steel_peclet"] = … or
--- v[name + "_border"] = …
local writers
local function writer_of(key)
  if not writers then
    writers = {}
    for _, piece in ipairs(pieces) do
      for _, line in ipairs(piece.code) do
        local index = line:match("%f[%w]v(%b[])")
        for word in (index or ""):gmatch('"([%w_]+)"') do writers[word] = writers[word] or piece end
      end
    end
  end
  for length = #key, 4, -1 do
    local piece = writers[key:sub(1, length)] or writers[key:sub(-length)]
    if piece then return piece end
  end
end

--- A number, or a formula with it, with a link to the chunk that writes it.
function linked_to_its_chunk(key, number)
  local piece = writer_of(key)
  if not piece then return number end
  local html = number.text
  if number.t == "Str" then html = escape(html) end
  return pandoc.RawInline("html", (link(anchor(piece), html):gsub("<a ", '<a title="' .. key .. '" ', 1)))
end

local function file_link(path) return link("file:" .. path, "<code>" .. escape(path) .. "</code>") end

--- Pandoc's HTML for a code.
local function coloured(text, language)
  local block = pandoc.CodeBlock(text, pandoc.Attr("", language ~= "" and { language } or {}))
  return pandoc.write(pandoc.Pandoc({ block }), "html5"):match("<code[^>]*>(.*)</code>")
end

--- The same, kept: to colour takes longer than all the rest.
local function coloured_once(text, language)
  return once("colours-" .. language, text, function() return coloured(text, language) end)
end

-- The tags of what has a colour: keywords <b>, types <u>, comments <i>. Operators, functions, attributes,
-- includes, strings and numbers have none of their own. With Pandoc's spans for all of them the report
-- would be half as large again.
local tags = { kw = "b", cf = "b", ot = "b", dt = "u", ex = "u", co = "i", ["do"] = "i", an = "i", cv = "i",
               ["in"] = "i", wa = "i" }

--- The lines of a code as HTML, by one of the two above; `@eq:id` in them becomes a link.
local function highlighted(lines, language, colour)
  local text = table.concat(lines, "\n")
    :gsub("@(%l+:[%w_-]+)", function(id) return "\u{E000}" .. id .. "\u{E001}" end)
  local out = {}
  for line in (colour(text, language) .. "\n"):gmatch("(.-)\n") do
    local inside = line:match('^<span id="cb1%-%d+"><a [^>]*></a>(.*)</span>$') or line
    inside = inside:gsub('<span class="(%l%l)">([^<]*)</span>', function(class, words)
      return tags[class] and string.format("<%s>%s</%s>", tags[class], words, tags[class]) or words
    end):gsub("&quot;", '"'):gsub("&#39;", "'"):gsub("&gt;", ">"):gsub("%]%]>", "]]&gt;")
    table.insert(out, (inside:gsub("\u{E000}(.-)\u{E001}", function(id)
      return refers(id) and referred(id) or "@" .. id
    end)))
  end
  return out
end

--- Gives each of these parts, which have `code` and `lang`, its `html`, line by line. Pandoc is called
--- once for all parts of a language, as each call reads the rules of the language again, which takes
--- longer than to colour a chunk.
local function highlight_all(parts)
  local lines, first = {}, {} -- language -> the lines of all its parts; part -> the first of its own
  for _, part in ipairs(parts) do
    local language = part.lang or ""
    lines[language] = lines[language] or pandoc.List()
    first[part] = #lines[language] + 1
    lines[language]:extend(part.code)
  end
  for language in pairs(lines) do
    lines[language] = highlighted(lines[language], language, draft and coloured or coloured_once)
  end
  for _, part in ipairs(parts) do
    part.html = table.move(lines[part.lang or ""], first[part], first[part] + #part.code - 1, 1, {})
  end
end

local chunk_code

--- Whether a reference is no more than a link: in a file, which stands whole in the index of files, and
--- where the chunk is what comes next.
local function stands_elsewhere(chunk, piece)
  return piece.file or chunk.pieces[1].place == piece.place + 1
end

--- A piece's code: runs of lines, and between them references that open to the chunk's own code or are
--- links.
local function piece_code(piece)
  if piece.shown then return piece.shown end
  local out, run = {}, {}
  local function flush()
    if #run > 0 then table.insert(out, "<pre>" .. table.concat(run, "\n") .. "\n</pre>") end
    run = {}
  end
  for k, line in ipairs(piece.code) do
    local space, name = tangle.reference(line)
    if chunks[name or ""] and stands_elsewhere(chunks[name], piece) then
      table.insert(run, space .. link(anchor(chunks[name].pieces[1]), chunks[name].html))
    elseif chunks[name or ""] then
      flush()
      local chunk = chunks[name]
      table.insert(out, string.format(
        '<details class="expand" style="--indent:%d"><summary>%s</summary>\n%s</details>',
        #space, link(anchor(chunk.pieces[1]), chunk.html), chunk_code(chunk)))
    else
      table.insert(run, piece.html[k])
    end
  end
  flush()
  piece.shown = table.concat(out, "\n")
  return piece.shown
end

function chunk_code(chunk)
  local parts = {}
  for _, piece in ipairs(chunk.pieces) do table.insert(parts, piece_code(piece)) end
  return table.concat(parts, "\n")
end

local function joined(pieces_using)
  local seen, out = {}, {}
  for _, piece in ipairs(pieces_using) do
    if not seen[piece.html_title] then table.insert(out, link(anchor(piece), piece.html_title)) end
    seen[piece.html_title] = true
  end
  return table.concat(out, ", ")
end

--- The chapter, without the folder of all chapters, and the line.
local function where(piece) return string.format("%s:%d", escape((piece.source:gsub("^paper/", ""))), piece.line) end

local function chunk_box(piece, open)
  local chunk, notes, parts = chunks[piece.id], {}, ""
  if piece.file then
    table.insert(notes, "file " .. file_link(piece.file))
  end
  if #chunk.users > 0 then table.insert(notes, "used in " .. joined(chunk.users)) end
  table.insert(notes, "in " .. where(piece))
  if #chunk.pieces > 1 then
    local function step(other, sign, label)
      local html = ' <a href="#%s" aria-label="%s">%s</a>'
      return other and html:format(anchor(other), label, sign) or ""
    end
    parts = string.format('<span>%spart %d of %d%s%s</span>',
      chunk.of_parts and chunk.html .. " += " or "", piece.part, #chunk.pieces,
      step(chunk.pieces[piece.part - 1], "↑", "previous"),
      step(chunk.pieces[piece.part + 1], "↓", "next"))
  end
  return raw(string.format('<details id="%s"%s><summary>'
    .. '<i>%s</i>%s</summary>\n<div>%s</div>'
    .. '<p>%s</p></details>', escape(anchor(piece)), open and ' open=""' or "",
    piece.html_title, parts, piece_code(piece), table.concat(notes, " · ")))
end

local function names_in(block)
  local names = pandoc.List()
  block:walk({ Code = function(inline) names:insert(inline.text) end })
  return names
end

--- To each equation of the paper its chunk, which is the one of that title, or the first that is told
--- behind it in its section, or the first that names it; and the tests named next, if it names none.
local function find_evidence(blocks)
  local place, pending, by_id = 0, {}, {}
  for _, item in ipairs(of_paper) do by_id[item.id] = item end
  for _, block in ipairs(blocks) do
    if block.t == "Header" then pending = {} end
    if block.t == "Div" and by_id[block.identifier] then table.insert(pending, by_id[block.identifier]) end
    if is_chunk(block) then place = place + 1 end
    for _, item in ipairs(pending) do
      if is_chunk(block) then item.chunk = item.chunk or pieces[place] end
      if block.t == "Div" and block.classes:includes("checked") then item.tests = item.tests or names_in(block) end
    end
  end
  for _, piece in ipairs(pieces) do
    for id in table.concat(piece.code, "\n"):gmatch("@(eq:[%w_-]+)") do
      if by_id[id] then by_id[id].chunk = by_id[id].chunk or piece end
    end
  end
  for _, item in ipairs(of_paper) do
    if item.titled then
      item.chunk = pieces:find_if(function(piece) return piece.title == item.titled end)
      if not item.chunk and item.titled ~= "none" then
        complain("#" .. item.id, "no chunk has the title %s", item.titled)
      end
    end
  end
end

local tests_led_to = {}

local function fill_equations(blocks)
  local rows = {}
  of_paper:sort(function(a, b)
    if a.first ~= b.first then return a.first < b.first end
    return tonumber(a.number) < tonumber(b.number)
  end)
  for _, item in ipairs(of_paper) do
    local tests = (item.tests or pandoc.List()):map(function(name)
      tests_led_to[name] = true
      return link("test:" .. name, "<code>" .. breakable(name) .. "</code>")
    end)
    table.insert(rows, string.format("<tr><td>%s</td><td>%s</td><td>%s</td><td>%s</td><td class=\"checked\">%s</td></tr>",
      escape(item.numbers), referred(item.id, true), item.status,
      item.chunk and link(anchor(item.chunk), item.chunk.html_title) or "–",
      #tests > 0 and table.concat(tests, ", ", 1, math.min(#tests, 2)) or "–"))
  end
  local html = "<table><thead><tr><th>paper</th><th>here</th><th>status</th><th>chunk</th><th>checked by</th></tr></thead>\n<tbody>"
    .. table.concat(rows, "\n") .. "</tbody></table>"
  return blocks:map(function(block)
    return block.t == "RawBlock" and block.text == equations_table and raw(html) or block
  end)
end

--- Chunks are folded to their titles, but for the one that is an equation: the first behind a numbered
--- one in its section. `.open` on a chunk opens it as well.
local function open_equations(blocks)
  local behind_equation = false
  return blocks:map(function(block)
    if block.t == "Header" then behind_equation = false end
    if block.t == "Div" and block.classes:includes("equation") and block.identifier ~= "" then
      behind_equation = true
    elseif is_chunk(block) then
      if behind_equation then block.classes:insert("open") end
      behind_equation = false
    end
    return block
  end)
end

local next_piece = 1
local function code_block(block)
  local piece = pieces[next_piece]
  if is_chunk(block) then
    next_piece = next_piece + 1
    local name = block.identifier ~= "" and block.identifier or block.attributes.file
    if not piece or piece.id ~= name then
      complain("#" .. name, "chunk %s: the tangler and Pandoc do not see the same fences", name)
      return nil
    end
    return chunk_box(piece, block.classes:includes("open"))
  end
  local lines = {}
  for line in (block.text .. "\n"):gmatch("(.-)\n") do table.insert(lines, line) end
  local html = table.concat(highlighted(lines, block.classes[1] or "", coloured), "\n")
  return raw('<div class="listing"><pre>' .. html .. "</pre></div>")
end

-- 8. The tests' names, quietly ----------------------------------------------------------------------

local function checked_by(paragraph)
  if names_tests(paragraph) then return pandoc.Div({ paragraph }, pandoc.Attr("", { "checked" })) end
end

function led_to_evidence(inlines)
  local out = pandoc.List()
  for _, inline in ipairs(inlines) do
    local kind, name = "", ""
    if inline.t == "Link" then kind, name = inline.target:match("^#?(%l*):?(.*)$") end
    local id = "test:" .. name
    if kind == "test" then tests_led_to[name] = true end
    if kind == "chunk" then
      local title = name:gsub("%%20", " ")
      local piece = pieces:find_if(function(piece) return piece.title == title end)
      if not piece then complain(title, "no chunk has the title %s", title) end
      id = piece and anchor(piece) or ""
    end
    if kind == "chunk" or kind == "test" then
      if #out > 0 and out[#out].t == "Space" then out:remove() end
      local html = (#out > 0 and ", " or "") .. link(id, utils.stringify(inline))
      inline = pandoc.RawInline("html", '<span class="sources">' .. html .. "</span>")
    end
    out:insert(inline)
  end
  return out
end

local function listing(id, title, note, html)
  return raw(string.format('<details class="file" id="%s"><summary><code>%s</code> '
    .. '<span class="note">%s</span></summary>\n<div><pre>%s\n</pre></div>'
    .. "</details>", escape(id), title, note, table.concat(html, "\n")))
end

--- A file whose code stands elsewhere as a whole.
local function mention(id, title, note)
  return raw(string.format('<p class="file" id="%s"><code>%s</code> <span class="note">%s</span></p>',
    escape(id), title, note))
end

--- Where the tests begin: name -> { file, head }. In C++ a test is TEST(Suite, Name); in the script of its
--- suite it is the function Name, or the one of this name in Python that it runs; the others are whole
--- scripts, whole programs for a fuzzer, or commands for CMake.
local function found_tests()
  local found = {}
  local function grep(expression, files)
    local done, lines = pcall(pandoc.pipe, "grep", { "-rsE", "--include=" .. files, expression, "tests" }, "")
    return done and lines or ""
  end
  for file, suite, name in grep("^TEST\\(\\w+, \\w+\\)", "*.cpp"):gmatch("([^\n:]+):TEST%((%w+), (%w+)%)") do
    found[suite .. "." .. name] = { file = file, head = "TEST(" .. suite .. ", " .. name .. ")" }
  end
  for file, name in grep("^int LLVMFuzzerTestOneInput", "*.cpp"):gmatch("([^\n:]+/(%l+)%.cpp):") do
    found["Fuzz." .. name:gsub("^%l", string.upper)] = { file = file }
  end
  for file, head, name in grep("^ *add_test\\(NAME \\w+\\.\\w+", "CMakeLists.txt"):gmatch("([^\n:]+): *(add_test%(NAME (%w+%.%w+))") do
    found[name] = { file = file, head = head }
  end
  local script = "([^\n:]+)/CMakeLists.txt: *thermoroll_script_tests?%((%w+)([%w.]*)%S* %S+ ([%w_-]+)%.sh"
  for folder, suite, name, file in grep("^ *thermoroll_script_tests?\\(", "CMakeLists.txt"):gmatch(script) do
    file = folder .. "/" .. file
    if #name > 1 then found[suite .. name] = { file = file .. ".sh" } end
    for case, body in (read(file .. ".sh") or ""):gmatch("%f[^\n](%u%w*)%(%) {([^\n]*)") do
      local in_python = body:find('run "${FUNCNAME[0]}"', 1, true)
      found[suite .. "." .. case] = { file = file .. (in_python and ".py" or ".sh"),
                                      head = in_python and "def " .. case .. "(" or case .. "() {" }
    end
  end
  return found
end

--- A test as it stands in its file, with what is said above it.
local function test_text(test)
  local text, comment = "\n" .. read(test.file) .. "\n", ""
  if not test.head then return (text:gsub("^\n#![^\n]*", ""):gsub("^\n+", "")) end
  text = text:gsub("\n +add_test", "\nadd_test")
  local from = text:find("\n" .. test.head, 1, true)
  local above, test_itself = text:sub(1, from), text:sub(from + 1)
  repeat
    local line = above:match("\n([/#][^!][^\n]*\n)$") or ""
    above, comment = above:sub(1, -#line - 1), line .. comment
  until line == ""
  local ends = { py = "^(.-\n)\n\n", txt = "^(.-%)\n)", cpp = "^(.-\n}\n)", sh = "^(.-\n}\n)" }
  return comment .. (test_itself:match("^[^\n]*}\n") or test_itself:match(ends[test.file:match("%w+$")]))
end

--- Tests, each below the command that runs it; a file is named where it begins.
local function listed_tests(names, tests)
  local lines, file = {}, nil
  for _, name in ipairs(names) do
    local test = tests[name]
    local mark = test.file:find("%.cpp$") and "//" or "#"
    local where_it_is = test.file ~= file and test.file .. ": " or ""
    file = test.file
    table.insert(lines, string.format('<i id="test:%s">%s %sctest --test-dir build/release -R %s</i>', name, mark, where_it_is, name))
    table.insert(lines, (escape(test_text(test)):gsub("\n+$", "\n"):gsub("&quot;", '"'):gsub("&gt;", ">"):gsub("%]%]>", "]]&gt;")))
  end
  return '<div><pre>' .. table.concat(lines, "\n") .. "</pre></div>"
end

--- Each test stands folded where a paragraph names it first; where it is named again, there or in a table, a
--- link leads to it.
local function fold_tests(blocks)
  local tests = found_tests()
  local function fold(div)
    if not div.classes:includes("checked") then return nil end
    local names = pandoc.List()
    local inlines = div.content[1]:walk({ Code = function(inline)
      local name, test = inline.text, tests[inline.text]
      if test and not test.told then names:insert(name) end
      local html = "<code>" .. (#name > 36 and breakable(name) or escape(name)) .. "</code>"
      local led = test and test.told
      if test then test.told = true end
      return pandoc.RawInline("html", led and link("test:" .. name, html) or html)
    end }).content
    if #names == 0 then return pandoc.Div({ pandoc.Plain(inlines) }, div.attr) end
    return { raw('<details class="checked"><summary>'), pandoc.Plain(inlines),
             raw("</summary>" .. listed_tests(names, tests) .. "</details>") }
  end
  local function lead(inline)
    local test, html = tests[inline.text], "<code>" .. breakable(inline.text) .. "</code>"
    if test then return pandoc.RawInline("html", test.told and link("test:" .. inline.text, html) or html) end
  end
  blocks = pandoc.Pandoc(blocks):walk({ Div = fold }).blocks
  blocks = pandoc.Pandoc(blocks):walk({ Table = function(rows) return rows:walk({ Code = lead }) end }).blocks
  for name in pairs(tests_led_to) do
    if not in_report and not (tests[name] and tests[name].told) then
      complain(name, "the test %s is led to, but not folded into a chapter", name)
    end
  end
  return blocks
end

-- 9. Back matter: bibliography, chunks, files, scripts, colophon -----------------------------------

local function heading(title, id)
  return pandoc.Header(2, title, pandoc.Attr(id, { "unnumbered" }))
end

local function sorted(map, key)
  local out = {}
  for _, item in pairs(map) do table.insert(out, item) end
  table.sort(out, function(a, b) return key(a) < key(b) end)
  return out
end

local function place_bibliography(blocks)
  local at, cites = #blocks + 1, false
  blocks:walk({ Cite = function() cites = true end })
  if not cites then return end
  for k, block in ipairs(blocks) do
    if block.t == "Div" and block.identifier == "refs" then return end
    if block.t == "Header" and block.classes:includes("appendix") then at = math.min(at, k) end
  end
  blocks:insert(at, heading("References", "references"))
  blocks:insert(at + 1, pandoc.Div({}, pandoc.Attr("refs")))
end

local function chunk_index()
  local function title(chunk)
    return (not chunk.of_parts and chunk.title or chunk.name):lower() .. "\0" .. chunk.name
  end
  local out = { '<ul class="index">' }
  for _, chunk in ipairs(sorted(chunks, title)) do
    local places = pandoc.List(chunk.pieces):map(function(piece)
      return link(anchor(piece), chunk.of_parts and piece.html_title or where(piece))
    end)
    table.insert(out, string.format("<li>%s<div><code>%s</code>%s%s</div></li>",
      link(anchor(chunk.pieces[1]), chunk.html), escape(chunk.name),
      #places > 1 and " · in " .. table.concat(places, ", ") or "",
      chunk.file and " · file " .. file_link(chunk.file) or ""))
  end
  table.insert(out, "</ul>")
  return raw(table.concat(out, "\n"))
end

--- The chunks with their lines in colours. References stay as they are, and the tangler takes the lines
--- as it takes the code.
local function coloured_chunks()
  local function only_comments(line) return (line:gsub("</?[bu]>", "")) end
  local coloured = {}
  for name, parts in pairs(collected) do
    coloured[name] = pandoc.List(parts):map(function(piece)
      local copy = { code = {} }
      for k, line in ipairs(piece.code) do copy.code[k] = tangle.reference(line) and line or only_comments(piece.html[k]) end
      return setmetatable(copy, { __index = piece })
    end)
  end
  return coloured
end

--- One piece without references.
local function stands_whole(chunk)
  local found = #chunk.pieces == 1
  for _, line in ipairs(chunk.pieces[1].code) do found = found and not tangle.reference(line) end
  return found
end

--- Studies and benchmarks are told piece by piece only: as whole files they would be 250 kB more.
local function is_of_studies(file) return file:match("^src/studies/") or file:match("^src/bench/") end

local function file_index()
  local out, coloured = pandoc.List(), coloured_chunks()
  for _, chunk in ipairs(sorted(chunks, function(c) return c.file or "" end)) do
    if chunk.file then
      local lines, from = tangle.expand(coloured, chunk.name)
      local id, is_whole = "file:" .. chunk.file, stands_whole(chunk)
      local is_listed = not is_whole and not is_of_studies(chunk.file)
      local note = string.format("%d %s from %s · %s", #lines, #lines == 1 and "line" or "lines",
        table.concat(from, ", "),
        link(anchor(chunk.pieces[1]), (is_whole and "whole in " or "told in ") .. chunk.html))
      out:insert(is_listed and listing(id, escape(chunk.file), note, lines)
        or mention(id, escape(chunk.file), note))
    end
  end
  return out
end

local function script_listings()
  local scripts = pandoc.List()
  local function script(name, note)
    local text = read("figures/" .. name .. ".gp")
    if not text then return end
    local lines = {}
    for line in text:gmatch("(.-)\n") do table.insert(lines, line) end
    -- Pandoc knows no gnuplot; the colours of R fit.
    scripts:insert({ name = name, note = note, code = lines, lang = "r" })
  end
  for _, item in ipairs(drawn) do
    script(item.name, string.format('%s · <span id="command:%s">make build/figures/%s.svg</span> · '
      .. '<span id="check:%s">ctest --test-dir build/release -R ShowsItsData/%s$</span>',
      referred(item.id), item.name, item.name, item.name, (item.name:gsub("-", "_"))))
  end
  script("style", "the style of all figures")
  highlight_all(scripts)
  return scripts:map(function(item)
    return listing("script:" .. item.name, escape("figures/" .. item.name .. ".gp"), item.note, item.html)
  end)
end

local function colophon(meta)
  local function count(map) return #sorted(map, tostring) end
  local text = string.format("Woven by Pandoc %s from %d chapters, which hold %d chunks of the program",
    tostring(PANDOC_VERSION), #chapters, count(chunks))
  if drawn[1] and drawn[1].drawer then
    text = text .. string.format("; %d figures drawn by %s", #drawn,
      drawn[1].drawer:gsub("GNUPLOT", "Gnuplot"):gsub(" patchlevel ", "."))
  end
  text = text .. "."
  local line = pandoc.Inlines({ pandoc.Str(text) })
  if meta.revision then line:insert(pandoc.Str(" Revision " .. utils.stringify(meta.revision) .. ".")) end
  if meta.date then
    line:extend({ pandoc.Str(" Date "), pandoc.Span(utils.stringify(meta.date) .. ".", pandoc.Attr("", { "one" })) })
  end
  if meta.tree then line:extend({ pandoc.Str(" Source tree "), pandoc.Code(utils.stringify(meta.tree)), pandoc.Str(".") }) end
  return pandoc.Para(line)
end

--- Parts and chapters as a list of links; the sections of a chapter are folded below it. (The contents that
--- Pandoc makes have ids, which would stand twice in a page that has them twice.)
local function contents(blocks)
  local list = pandoc.List()
  for _, block in ipairs(blocks) do
    if block.t == "Header" and block.level <= 3 then
      local entry = { pandoc.Plain({ pandoc.Link(block.content, "#" .. block.identifier) }) }
      local part = block.attributes.part
      if part then list:insert({ { pandoc.Plain({ pandoc.Strong(part) }) }, sections = {} }) end
      if block.level == 2 or #list == 0 then
        list:insert({ entry, sections = {} })
      else
        table.insert(list[#list].sections, entry)
      end
    end
  end
  return pandoc.BulletList(list:map(function(chapter)
    local entry = chapter[1]
    if #chapter.sections == 0 then return entry end
    return { raw("<details><summary>"), entry[1], raw("</summary>"), pandoc.BulletList(chapter.sections),
             raw("</details>") }
  end))
end

local function add_back_matter(document)
  local blocks = document.blocks
  place_bibliography(blocks)
  if #pieces > 0 and not in_report then
    blocks:extend({ heading("Index of chunks", "index-of-chunks"), chunk_index(),
                    heading("Index of files", "index-of-files") })
    blocks:extend(file_index())
  end
  if #drawn > 0 and not in_report then
    blocks:insert(heading("Scripts of the figures", "scripts"))
    blocks:extend(script_listings())
  end
  blocks:insert(heading("Colophon", "colophon"))
  blocks:insert(colophon(document.meta))
end

-- The whole -----------------------------------------------------------------------------------------

local function paragraph(block)
  return figure_alone(block) or cut_at_formulas(block) or checked_by(block)
end

--- Of the whole, in which all is numbered, keeps the chapter that is drafted, and of the chunks its own
--- in colours.
local function keep_draft(document)
  local blocks, chapter = pandoc.List(), 0
  for _, block in ipairs(document.blocks) do
    if block.t == "Header" and block.level == 2 then chapter = chapter + 1 end
    if chapters[chapter] and chapters[chapter].name == draft then blocks:insert(block) end
  end
  document.blocks = blocks
  local own = pandoc.List(pieces):filter(function(piece) return piece.source == draft end)
  for k = #pieces, 1, -1 do
    pieces[k].html = pandoc.List(pieces[k].code):map(escape)
    if pieces[k] == own[1] then next_piece = k end
  end
  return own
end

--- Forgets all numbers, but for the links into the report.
local function number_anew()
  in_report, labels, counts, section, appendices = labels, {}, {}, { 0, 0, 0 }, false
  drawn, card_rules, of_paper = {}, pandoc.List(), pandoc.List()
end

-- In a page without the solver its places are left out, but for a sentence in the large one.
local function without_solver(div)
  if div.attributes.large then
    local how = "This page was made without the solver: "
    return pandoc.Para({ pandoc.Str(how), pandoc.Code("make setup live"), pandoc.Str(" makes one with it.") })
  end
  if div.classes:includes("live") or div.classes:includes("screen") then return {} end
end

--- The sections that tell which files a chapter's pieces make, each as a division: they are not printed.
local function divided(blocks)
  local out, inside = pandoc.List(), nil
  for _, block in ipairs(blocks) do
    if block.t == "Header" then
      inside = utils.stringify(block):match("Source files$") and pandoc.List() or nil
      if inside then out:insert(pandoc.Div(inside, pandoc.Attr("", { "assembly" }))) end
    end
    if inside then
      inside:insert(block)
      out[#out].content = inside
    else
      out:insert(block)
    end
  end
  return out
end

function Pandoc(document)
  for _, name in ipairs(PANDOC_STATE.input_files) do
    table.insert(chapters, { name = name, text = read(name) or "" })
  end
  draft = document.meta.draft and utils.stringify(document.meta.draft)
  collect_chunks()
  if document.meta.colours then -- which `make` keeps before there is anything to write them into
    highlight_all(pieces)
    return pandoc.Pandoc({})
  end
  -- First all that has a number, then all that refers to one.
  only_numbered = document.meta.paper ~= nil
  if not document.meta.live then document.blocks = document.blocks:walk({ Div = without_solver }) end
  local numbering = { Header = number_heading, Para = paragraph, Table = written_table, Div = generated_table }
  local numbered = pandoc.Pandoc(whole(document.blocks)):walk(numbering).blocks
  if document.meta.paper then
    only_numbered = false
    number_anew()
    numbered = pandoc.Pandoc(shortened_text(document.blocks)):walk(numbering).blocks
  end
  document.meta.abstract = document.meta.paper and document.meta["abstract-short"] or document.meta.abstract
  document.meta["abstract-short"] = nil
  document.blocks = open_equations(numbered)
  if not document.meta.paper then highlight_all(draft and keep_draft(document) or pieces) end
  if not draft then find_evidence(document.blocks) end
  document.blocks = fold_tests(fill_equations(document.blocks))
  local body = { CodeBlock = code_block } -- in one walk, which is faster than one for each
  for kind, filter in pairs(prose) do body[kind] = filter end
  document = document:walk(body)
  if draft then
    place_bibliography(document.blocks)
  else
    add_back_matter(document)
  end
  stop_on_mistakes()
  document.meta.style = raw(style .. table.concat(card_rules, "\n") .. "\n" .. formula_font())
  document.meta.contents = pandoc.MetaBlocks({ contents(document.blocks) })
  document.blocks = in_sections(divided(document.blocks))
  return document:walk({ Header = part_before })
end
